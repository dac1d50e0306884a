#include "quadrature/quadrature.h"

#include "test.h"

TEST_CASE("a Monte Carlo rule integrates a constant exactly") {
    Random random(1, 0);
    for (std::size_t n : {1u, 2u, 40u, 1000u}) {
        const QuadratureRule rule = monte_carlo_rule(place_directions(Placement::uniform, n, random));
        double sum = 0;
        for (double weight : rule.weights) sum += weight;
        CHECK(std::fabs(sum / (2 * pi) - 1) < 1e-13);  // n roundings
        CHECK(rule.directions.size() == n);
    }
}

TEST_CASE("a Monte Carlo rule on cosine-distributed directions knows the cosine and integrates it exactly") {
    Random random(1, 3);
    for (const Placement placement : {Placement::cosine, Placement::cosine_fibonacci}) {
        const QuadratureRule rule = monte_carlo_rule(place_directions(placement, 40, random));
        CHECK(rule.known == KnownPart::cosine);
        CHECK(known_part(rule.known, {0.6, 0.8, 0}) == 0.8);
        double sum = 0;
        for (double weight : rule.weights) sum += weight;
        CHECK(std::fabs(sum / pi - 1) < 1e-14);
    }
}

TEST_CASE("a Bayesian rule has the weights of the Gaussian process on its directions") {
    Random random(1, 1);
    const std::vector<Vec3> directions = uniform_directions(20, random);
    const QuadratureRule rule = bayesian_rule(Sobolev(), 0.01, directions);
    CHECK(rule.weights == GaussianProcess(Sobolev(), 0.01, directions).weights());
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
