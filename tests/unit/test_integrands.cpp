#include "experiments/integrands.h"
#include "experiments/models.h"

#include "test.h"

TEST_CASE("the integrands' truths agree with a dense quadrature") {
    // 2e5 Fibonacci points; the edges of the environment and of shadows leave an error of about n^(-3/4), 1e-4.
    const std::vector<Vec3> directions = fibonacci_directions(200000);
    std::vector<Integrand> integrands = practice_integrands();
    const auto light = std::make_shared<const EnvironmentMap>(load_environment());
    for (Integrand& integrand : scene_integrands(light, 5)) integrands.push_back(std::move(integrand));
    CHECK(integrands.size() == 9);
    for (const Integrand& integrand : integrands) {
        double sum = 0;
        for (const Vec3& direction : directions) sum += integrand.value(direction);
        CHECK(std::fabs(2 * pi / 2e5 * sum / integrand.truth - 1) < 3e-4);
    }
}
