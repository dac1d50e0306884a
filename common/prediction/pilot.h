// The error of a picture before it is rendered. A pilot is the picture at some thousand of its pixels, with the random
// numbers that they have in it, of which only the error is predicted.
#pragma once

#include "prediction/predicted_error.h"

namespace bmc {
struct Pilot {
    Color squared_amplitude;  // a^2, the mean over the pixels that show an object
    double rmse;              // predicted, of linear radiance over these pixels and all colours
};

// From every k-th pixel of each row and each column, k being a 32nd of their number (at least 1). Throws as error_of
// does.
Pilot run_pilot(const Scene& scene, const RenderSettings& settings, const ErrorOf& error_of);

// The predicted standard errors of a picture, 0 where it shows no object.
Image predicted_errors(const Scene& scene, const RenderSettings& settings, const ErrorOf& error_of,
                       const Progress& progress = nullptr);

struct ChosenSamples {
    std::size_t samples;
    double rmse;  // predicted
};

// The fewest samples with which the predicted RMSE is at most the target: by pilots with least, 2 least, 4 least, ...
// samples, and between the last two along the power of the samples that leads from the one to the other. most: at least
// 4. error_of gives the errors of a picture by these settings; it may be of fewer processes, which changes nothing that
// is expected of an error. Throws std::runtime_error, with the RMSE that they have, if so many do not suffice, and what
// error_of throws.
ChosenSamples samples_for(double target, std::size_t least, std::size_t most, const Scene& scene,
                          RenderSettings settings, const std::function<ErrorOf(const RenderSettings&)>& error_of);
}  // namespace bmc
