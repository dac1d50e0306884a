// The irradiance of a surface that nothing shadows, for every orientation that it can have:
//     E(n) = integral of L cos(theta) d omega over the hemisphere around the normal n,
// a table in place of nine harmonics, whose error is a few percent (Ramamoorthi & Hanrahan, "An efficient
// representation for irradiance environment maps", SIGGRAPH 2001).
#pragma once

#include "light/environment.h"

namespace bmc::beyond {
class IrradianceMap {
public:
    // threads: how many to use.
    explicit IrradianceMap(const EnvironmentMap& environment, std::size_t threads = 1);

    // E(n) of a unit normal, linear RGB. The error is below 2e-3 of the largest E, if there is no sun (sun.h).
    Color operator()(Vec3 normal) const;

private:
    EnvironmentMap table_;
};
}  // namespace bmc::beyond
