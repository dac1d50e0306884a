// The irradiance of a surface that nothing shadows, for every orientation that it can have:
//     E(n) = integral of L cos(theta) dw over the hemisphere around the normal n,
// a table in place of nine harmonics, whose error is a few percent (Ramamoorthi & Hanrahan, "An efficient
// representation for irradiance environment maps", SIGGRAPH 2001).
#pragma once

#include "light/environment.h"

#include <vector>

namespace bmc {
class IrradianceMap {
public:
    // Made by so many threads. Throws std::runtime_error where a radiance exceeds 1e36: its integrals would exceed the
    // largest float.
    explicit IrradianceMap(const EnvironmentMap& environment, unsigned threads = 1);

    // E(n) of a unit normal, linear RGB. The error is below 1e-3 of the largest E. If much of the light comes from a
    // source of less than one degree it can be larger: 1.3e-2 if all of it comes from a single texel of 1024 x 512.
    Color operator()(Vec3 normal) const;

private:
    TexelGrid grid_;
    std::vector<float> rgb_;
};
}  // namespace bmc
