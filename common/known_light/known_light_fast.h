// The function visible_sky of known_light.h, faster and with the same bits.
#pragma once

#include "known_light/known_light.h"

namespace bmc {
Color visible_sky_fast(const Scene& scene, const EnvironmentMap& means, const Hit& hit, const CosineRule& rule,
                       const Frame& frame);
}  // namespace bmc
