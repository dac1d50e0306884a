#include "quadrature/placement.h"

#include "base/formatted.h"

namespace bmc {
std::string Placement::name() const {
    const std::string of_uniform = name_of(set, point_set_names);
    if (density == KnownPart::nothing) return of_uniform;
    return set == PointSet::random ? "cosine" : "cosine-" + of_uniform;
}

std::vector<Placement> all_placements() {
    std::vector<Placement> all;
    for (const KnownPart density : {KnownPart::nothing, KnownPart::cosine})
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
    const KnownPart p = placement.density;
    switch (placement.set) {
        case PointSet::random: return [=](Random& random) { return random_directions(n, random, p); };
        case PointSet::stratified: return [=](Random& random) { return stratified_directions(n, random, p); };
        case PointSet::fibonacci: return rotated(fibonacci_directions(n, p));
        case PointSet::optimised: break;
    }
    return rotated(optimised_directions(n, p));
}
}  // namespace bmc
