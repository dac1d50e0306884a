#include "quadrature/placement.h"

#include "test.h"

TEST_CASE("a placement is a set of a density; a fixed set is the same each time but for a rotation") {
    for (const Placement placement : all_placements()) {
        CAPTURE(placement.name());
        const Density density = placement.density;
        Random random(1, 0), same(1, 0);
        const Sampler sampler = sampler_of(placement, 7);
        Vec3 mean;  // of 1400 directions, within five standard errors
        for (int draw = 0; draw < 200; ++draw) {
            std::vector<Vec3> expected = placement.set == PointSet::fibonacci   ? fibonacci_directions(7, density)
                                         : placement.set == PointSet::optimised ? optimised_directions(7, density)
                                         : placement.set == PointSet::stratified
                                             ? stratified_directions(7, same, density)
                                             : random_directions(7, same, density);
            const double turns = placement.is_fixed() ? same.uniform() : 0;
            for (Vec3& direction : expected) direction = rotate_around_y(direction, turns);
            CHECK(sampler(random) == expected);
            for (const Vec3& direction : expected) mean += 1 / 1400.0 * direction;
        }
        CHECK(length(mean - Vec3{0, density == Density::cosine ? 2.0 / 3 : 0.5, 0}) < 0.08);
    }
}
