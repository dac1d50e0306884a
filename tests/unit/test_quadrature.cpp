#include "quadrature/quadrature.h"

#include "test.h"

TEST_CASE("a Monte Carlo rule integrates its known part exactly: 1, or the cosine that its directions follow") {
    Random random(1, 0);
    for (const auto& named : placement_names)
        for (std::size_t n : {1u, 2u, 40u, 1000u}) {
            const Placement placement = named.second;
            const QuadratureRule rule = monte_carlo_rule(place_directions(placement, n, random));
            const bool cosine = placement == Placement::cosine || placement == Placement::cosine_fibonacci;
            CAPTURE(named.first);
            CHECK(rule.known == (cosine ? Known::cosine : Known::nothing));
            CHECK(known_part(rule.known, {0.6, 0.8, 0}) == (cosine ? 0.8 : 1));
            CHECK(rule.directions.size() == n);
            double sum = 0;
            for (double weight : rule.weights) sum += weight;
            CHECK(std::fabs(sum / ((cosine ? 1 : 2) * pi) - 1) < 1e-13);  // n roundings
        }
}

TEST_CASE("placements: uniform sets are fresh, Fibonacci sets are one set turned by fresh angles") {
    Random random(1, 2);
    const std::vector<Vec3> a = place_directions(Placement::uniform, 10, random).directions,
                            b = place_directions(Placement::uniform, 10, random).directions;
    CHECK(a[0].y != b[0].y);
    const std::vector<Vec3> plain = fibonacci_directions(10),
                            turned = place_directions(Placement::fibonacci, 10, random).directions;
    for (std::size_t i = 0; i < 10; ++i) {
        CHECK(turned[i].y == plain[i].y);
        CHECK(turned[i].x != plain[i].x);
        CHECK(std::fabs(dot(turned[i], turned[0]) - dot(plain[i], plain[0])) < 1e-15);
    }
}
