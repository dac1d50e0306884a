// The pictures of the programs: the one place that knows the practice's, those with a known light, and the shared ones.
#pragma once

#include "known_light/prefiltered_environment.h"
#include "options.h"

#include <memory>

namespace bmc {
struct PictureSettings : RenderSettings {
    bool shared = false;  // neighbouring pixels share what they see of a known light
};

// Monte Carlo takes one of a process's options: that the light is known.
struct PictureOptions : RenderOptions {
    Option share;

    explicit PictureOptions(PictureSettings& settings);
};

// An environment, which must outlive it, and its averages where the light is to be known.
struct EnvironmentLight {
    const EnvironmentMap& environment;
    std::shared_ptr<const PrefilteredEnvironment> prefiltered = nullptr;
};

// The environment with its averages, which so many threads make.
EnvironmentLight prefilter(const EnvironmentMap& environment, unsigned threads = 1);

// The colour of each point of a picture. Scene and light must outlive it. Throws what the Gaussian processes throw.
Shade shade_of(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings);

// The image of linear radiance, throwing alike.
Image picture(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings);
}  // namespace bmc
