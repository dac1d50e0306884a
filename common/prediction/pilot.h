// The error of a picture before it is rendered. A pilot predicts the errors of about a thousand of its pixels, with the
// random numbers that they have in the picture.
#pragma once

#include "prediction/predicted_error.h"

namespace bmc {
struct Pilot {
    Color squared_amplitude;  // a^2, the mean over the pixels that show an object
    double rmse;              // predicted, of linear radiance over these pixels and all colours
};

// At every k-th pixel of every k-th row, k a 32nd of the width and of the height (at least 1). Throws what error_of
// throws.
Pilot run_pilot(const Scene& scene, const RenderSettings& settings, const ErrorOf& error_of);

// The predicted standard errors of a picture, 0 where it shows no object.
Image predicted_errors(const Scene& scene, const RenderSettings& settings, const ErrorOf& error_of,
                       const Progress& progress = nullptr);

struct ChosenSamples {
    std::size_t samples;
    double rmse;  // predicted
};

// The fewest samples with which the predicted RMSE is at most the target. Pilots try least, 2 least, 4 least, ...
// samples; between the last two the RMSE is interpolated as a power of the samples. most: at least 4. error_of gives
// the errors of a picture by settings, which have at most eight processes: that does not change the expected error.
// Throws std::runtime_error, which tells the RMSE of the most samples, if they do not suffice; and what error_of
// throws.
ChosenSamples samples_for(double target, std::size_t least, std::size_t most, const Scene& scene,
                          RenderSettings settings, const std::function<ErrorOf(const RenderSettings&)>& error_of);
}  // namespace bmc
