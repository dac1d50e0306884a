// Pictures of the sphere scene, the practice's and those under a known light.
#pragma once

#include "beyond/known_light/known_light.h"

#include <memory>

namespace bmc::beyond {
struct PictureSettings : RenderSettings {
    bool light_known = false;  // then the cosine is known, too: the known part of a process is Known::cosine
};

// An environment, and its averages where the light is to be known. The environment must outlive it.
struct EnvironmentLight {
    const EnvironmentMap& environment;
    std::shared_ptr<const PrefilteredEnvironment> prefiltered = nullptr;

    EnvironmentLight(const EnvironmentMap& map, bool known, unsigned threads);
};

// The rules of a picture, and with them the colour of each of its points. Scene and light must outlive the latter. The
// first throws what the Gaussian processes throw.
PixelRules rules_of(const EnvironmentLight& light, const PictureSettings& settings);
Shader shader_of(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings,
                 const PixelRules& rules);

// The image of linear radiance. Throws as rules_of does.
Image picture(const EnvironmentLight& light, const PictureSettings& settings);
}  // namespace bmc::beyond
