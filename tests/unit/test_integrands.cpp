#include "experiments/integrands.h"
#include "test.h"

// 1e5 Fibonacci points; the edges of a picture leave an error of about n^(-3/4), 2e-4.
TEST_CASE("the practice's integrands are its four functions, with their integrals") {
    for (const char* const name : integrand_names) {
        const Integrand integrand = integrand_named(name);
        double sum = 0;
        for (const Vec3& w : fibonacci_directions(100000)) sum += 2 * pi / 1e5 * integrand.value(w);
        CHECK_MESSAGE(relative(integrand.truth, sum) < 5e-4, integrand.formula);
    }
}

TEST_CASE("the integrand of a light is luminance above a tilted surface, times cos(theta)") {
    const auto even = std::make_shared<const EnvironmentMap>(map_of(2, 2, [](int, int) { return Colour{1, 2, 4}; }));
    const auto map = std::make_shared<const EnvironmentMap>(coloured_map(16, 9));
    const double luminance_of_light = 0.2126 + 2 * 0.7152 + 4 * 0.0722;
    CHECK(relative(environment_integrand(even).value({0.6, 0.8, 0}), 0.8 * luminance_of_light) < 1e-15);
    CHECK(relative(environment_integrand(even).truth, pi * luminance_of_light) < 1e-9);  // midpoints of a line
    CHECK(relative(environment_integrand(map).value({0, 1, 0}), luminance(map->radiance(normalize({0.3, 0.6, -0.7})))) <
          1e-15);
}

TEST_CASE("an integrand's samples are over the known part, and a rule sums them") {
    const auto integrand = [](Vec3 w) { return 2 + w.x; };
    const std::vector<Vec3> directions{{0.6, 0.8, 0}, {0, 0.5, 0}, {0, 0x1p-40, 0}};  // the last at the horizon
    CHECK(unknown_part(integrand, directions) == std::vector<double>{2.6, 2, 2});
    CHECK(unknown_part(integrand, directions, Known::cosine) == std::vector<double>{2.6 / 0.8, 4, 0x1p41});
    CHECK(relative(estimate({directions, {10, 100, 0}, Known::cosine}, integrand), 432.5) < 1e-15);
}
