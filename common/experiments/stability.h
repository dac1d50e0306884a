// The sample sets that the report on stability compares.
#pragma once

#include "base/vec3.h"

#include <string_view>
#include <vector>

namespace bmc {
// n directions. random: uniform; duplicates: half as many, each of them twice; equator: all on the horizon; pole: all
// at the pole; cluster: all within 1e-8 of one direction.
std::vector<Vec3> sample_set(std::string_view name, std::size_t n);
}  // namespace bmc
