#include "quadrature/placement.h"

#include "base/formatted.h"

#include <stdexcept>

namespace bmc {
std::string Placement::name() const {
    if (set == PointSet::random) return name_of(density, density_names);
    return (density == Density::cosine ? "cosine-" : "") + std::string(name_of(set, point_set_names));
}

std::vector<Placement> all_placements() {
    std::vector<Placement> all;
    for (const Density density : {Density::uniform, Density::cosine})
        for (std::size_t i = 0; i < std::size(point_set_names); ++i) all.push_back({static_cast<PointSet>(i), density});
    return all;
}

static Sampler rotated(const std::vector<Vec3>& fixed) {
    return [=](Random& random) {
        std::vector<Vec3> directions = fixed;
        const double turns = random.uniform();
        for (Vec3& direction : directions) direction = rotate_around_y(direction, turns);
        return directions;
    };
}

Sampler sampler_of(Placement placement, std::size_t n) {
    const Density density = placement.density;
    switch (placement.set) {
        case PointSet::random: return [=](Random& random) { return random_directions(n, random, density); };
        case PointSet::stratified: return [=](Random& random) { return stratified_directions(n, random, density); };
        case PointSet::fibonacci: return rotated(fibonacci_directions(n, density));
        case PointSet::optimised: return rotated(optimised_directions(n, density));
    }
    throw std::logic_error("sampler_of has no case for this set");
}
}  // namespace bmc
