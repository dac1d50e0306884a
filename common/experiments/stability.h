// The sample sets that the report on stability compares.
#pragma once

#include "base/vec3.h"

#include <vector>

namespace bmc {
// n directions: random and uniform; half as many, each of them twice; all on the horizon; all at the pole; all within
// 1e-8 of one direction.
enum class SampleSet { random, duplicates, equator, pole, cluster };
inline constexpr const char* sample_set_names[] = {"random", "duplicates", "equator", "pole", "cluster"};
std::vector<Vec3> sample_set(SampleSet set, std::size_t n);
}  // namespace bmc
