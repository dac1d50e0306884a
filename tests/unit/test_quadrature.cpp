#include "quadrature/quadrature.h"
#include "test.h"

// With cos(theta), the weights are pi times 2, -1.6 and 0.5 if nothing is known.
TEST_CASE("white brightness and noise gain are those of the weights in a picture") {
    const std::vector<Vec3> directions{{0, 1, 0}, {0.6, 0.8, 0}, {std::sqrt(0.75), 0.5, 0}};
    const QuadratureRule rule{directions, {2 * pi, -2 * pi, pi}, Known::nothing},
        cosine{directions, {2 * pi, -1.6 * pi, 0.5 * pi}, Known::cosine};
    for (const QuadratureRule& each : {rule, cosine}) {
        CAPTURE(name_of(each.known, known_names));
        CHECK(relative(white_brightness(each), 0.9) < 1e-14);
        CHECK(relative(noise_gain(each), std::sqrt((4 + 2.56 + 0.25) * 9 / 4)) < 1e-14);
    }
    const QuadratureRule lattice = monte_carlo_rule(fibonacci_directions(1000));
    CHECK(relative(white_brightness(lattice), 1) < 1e-14);  // cosines in equal steps
    CHECK(relative(noise_gain(lattice), 1) < 1e-6);
}
