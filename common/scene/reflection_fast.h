// The function reflected_light of reflection.h, faster and with the same bits.
#pragma once

#include "scene/reflection.h"

namespace bmc {
Color reflected_light_fast(const Scene& scene, const EnvironmentMap& environment, const Hit& hit,
                           const CosineRule& rule, const Frame& frame);
}  // namespace bmc
