// The pictures of the programs: the one place that knows the practice's, those with a known light, and the shared ones.
#pragma once

#include "known_light/prefiltered_environment.h"
#include "options.h"

#include <memory>

namespace bmc {
struct PictureSettings : RenderSettings {
    bool shared = false;  // neighbouring pixels share what they see of a known light
};

// With Monte Carlo, accepts only --known light of the process's options.
struct PictureOptions : RenderOptions {
    Option share;

    explicit PictureOptions(PictureSettings& settings);
};

// An environment, and its averages where the light is to be known. The environment must outlive it.
struct EnvironmentLight {
    const EnvironmentMap& environment;
    std::shared_ptr<const PrefilteredEnvironment> prefiltered = nullptr;
};

// The environment with its averages. threads: how many to use.
EnvironmentLight prefilter(const EnvironmentMap& environment, unsigned threads = 1);

// The colour of each point of a picture. Scene and light must outlive it. Throws what the Gaussian processes throw.
Shade shade_of(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings);

// The image of linear radiance. Throws as shade_of does.
Image picture(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings);
}  // namespace bmc
