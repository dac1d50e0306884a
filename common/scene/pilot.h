// The error of a picture before it is rendered. A pilot is the picture at some thousand of its pixels, with the random
// numbers that they have in it, of which only the error is predicted.
#pragma once

#include "scene/predicted_error.h"

struct Pilot {
    Color amplitude;  // a^2, the mean over the pixels that show an object
    double rmse;      // predicted, of linear radiance over these pixels and all colours
};

// From every k-th pixel of each row and each column, k being a 32nd of their number (at least 1). The rules that pixels
// share have been made, with their processes. Throws as pixel_error does.
Pilot run_pilot(const Scene& scene, const Light& light, const RenderSettings& settings, const PixelRules& rules);

struct ChosenSamples {
    std::size_t samples;
    double rmse;  // predicted
};

// The fewest samples, but at least 2, with which the predicted RMSE is at most the target: by pilots with 2, 4, 8, ...
// samples (from 4 on where a known sun takes some of them), and between the last two by the power of the samples that
// leads from the one to the other. most: at least 4. Throws std::runtime_error, with the RMSE that they have, if so
// many do not suffice, and what the Gaussian processes throw.
ChosenSamples samples_for(double target, std::size_t most, const Scene& scene, const Light& light,
                          RenderSettings settings);
