// The options of a picture that go beyond the practice, and the picture that they ask for.
#pragma once

#include "options.h"
#include "picture.h"

namespace bmc {
// Monte Carlo takes one of a process's options: that the light is known.
struct PictureOptions : RenderOptions {
    Option rmse, show;

    explicit PictureOptions(PictureSettings& settings);
};

// Throws UsageError where errors are asked for and the settings' samples say nothing of them.
void require_predictable(const PictureSettings& settings);

// The picture of the sphere scene under the environment, for a file of this format. A prediction that is asked for is
// told on stderr. In a PPM errors are grey, twice their root mean square white. Throws as picture and samples_for do,
// and UsageError for an RMSE under a sun (sun.h) where the light is not known.
Image asked_picture(const EnvironmentMap& environment, PictureSettings settings, Format format,
                    const Progress& progress);
}  // namespace bmc
