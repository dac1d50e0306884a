// The function reflected_light of reflection.h, faster and with the same bits.
#pragma once

#include "scene/reflection.h"

namespace bmc {
// The sum of weights times radiance over the directions that the other object does not shadow; or over all of them.
Color irradiance_fast(const Scene& scene, const EnvironmentMap& environment, const Hit& hit, const CosineRule& rule,
                      const Frame& frame);
Color unshadowed_irradiance_fast(const EnvironmentMap& environment, const CosineRule& rule, const Frame& frame);

Color reflected_light_fast(const Scene& scene, const EnvironmentMap& environment, const Hit& hit,
                           const CosineRule& rule, const Frame& frame);
}  // namespace bmc
