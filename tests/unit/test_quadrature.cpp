#include "quadrature/quadrature.h"
#include "test.h"

TEST_CASE("a placement is a set of a density; a fixed set is the same each time but for a rotation") {
    std::string names;
    for (const Placement placement : all_placements()) {
        names += placement.name() + ' ';
        CAPTURE(names);
        const KnownPart p = placement.density;
        Random random(1, 0), same(1, 0);
        const Sampler sampler = sampler_of(placement, 7);
        for (int draw = 0; draw < 2; ++draw) {
            std::vector<Vec3> expected = placement.set == PointSet::fibonacci    ? fibonacci_directions(7, p)
                                         : placement.set == PointSet::optimised  ? optimised_directions(7, p)
                                         : placement.set == PointSet::stratified ? stratified_directions(7, same, p)
                                                                                 : random_directions(7, same, p);
            const double turns = placement.is_fixed() ? same.uniform() : 0;
            for (Vec3& direction : expected) direction = rotate_around_y(direction, turns);
            CHECK(sampler(random) == expected);
        }
    }
    CHECK(names ==
          "uniform stratified fibonacci optimised cosine cosine-stratified cosine-fibonacci cosine-optimised ");
}

// With cos(theta), the weights are pi times 2, -1.6 and 0.5 if nothing is known.
TEST_CASE("white brightness and noise gain are those of the weights in a picture") {
    const std::vector<Vec3> directions{{0, 1, 0}, {0.6, 0.8, 0}, {std::sqrt(0.75), 0.5, 0}};
    const QuadratureRule rule{directions, {2 * pi, -2 * pi, pi}, KnownPart::nothing},
        cosine{directions, {2 * pi, -1.6 * pi, 0.5 * pi}, KnownPart::cosine};
    for (const QuadratureRule& each : {rule, cosine}) {
        CAPTURE(each.known_part);
        CHECK(relative(white_brightness(each), 0.9) < 1e-14);
        CHECK(relative(noise_gain(each), std::sqrt((4 + 2.56 + 0.25) * 9 / 4)) < 1e-14);
    }
    const QuadratureRule lattice = monte_carlo_rule(fibonacci_directions(1000));
    CHECK(relative(white_brightness(lattice), 1) < 1e-14);  // cosines in equal steps
    CHECK(relative(noise_gain(lattice), 1) < 1e-6);
}
