// How the directions of a rule are placed: as a set of points, of a density (hemisphere.h).
#pragma once

#include "quadrature/hemisphere.h"

#include <functional>
#include <string>

namespace bmc {
enum class PointSet { random, stratified, fibonacci, optimised };
inline constexpr const char* point_set_names[] = {"random", "stratified", "fibonacci", "optimised"};
struct Placement {
    PointSet set = PointSet::random;
    Density density = Density::uniform;

    // Whether all sets are one, but for a rotation: a lattice, or an optimised set.
    bool is_fixed() const { return set == PointSet::fibonacci || set == PointSet::optimised; }

    std::string name() const;  // uniform, cosine, stratified, cosine-stratified, ...
};
std::vector<Placement> all_placements();

// Draws a fresh set of n >= 1 directions. A fixed set is made once, here, and then rotated by random angles.
using Sampler = std::function<std::vector<Vec3>(Random&)>;
Sampler sampler_of(Placement placement, std::size_t n);
}  // namespace bmc
