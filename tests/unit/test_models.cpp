#include "experiments/models.h"
#include "test.h"

TEST_CASE("the scene's integrands have their truth by dense quadrature") {
    const auto light = std::make_shared<const EnvironmentMap>(coloured_map(16, 9));
    const std::vector<Integrand> integrands = scene_integrands(light, 5);
    REQUIRE(integrands.size() == 5);
    int shadowed = 0;
    for (const Integrand& integrand : integrands) {
        CAPTURE(integrand.name);
        double sum = 0, brightest = 0;
        for (const Vec3& w : fibonacci_directions(50000)) {
            const double value = integrand.value(w);
            sum += 2 * pi / 5e4 * value;
            shadowed += value == 0;
            brightest = std::max(brightest, value / w.y);
        }
        CHECK(brightest <= (1 + 1e-15) * luminance({16.5, 9.25, 10.125}));  // the brightest texel
        CHECK(relative(integrand.truth, sum) < 3e-3);                       // edges
    }
    CHECK(shadowed > 100);
}

// Two samples: Q = [a b; b a], whose inverse and determinant are elementary.
TEST_CASE("the log evidence is the density's logarithm with the best amplitude") {
    const GaussianProcess process(Sobolev(), 0.1, {{0, 1, 0}, {0.6, 0.8, 0}});
    const double a = 8.0 / 3 + 0.01, b = 8.0 / 3 - std::sqrt(0.4), determinant = a * a - b * b;
    const double form = (a * (1 + 9) - 2 * b * 3) / determinant;  // Y = (1, 3)
    CHECK(std::fabs(log_evidence(process, {1, 3}) - (-std::log(form / 2) - 0.5 * std::log(determinant))) < 1e-14);
}
