// Tests of your own, with doctest: a TEST_CASE states a fact, and each CHECK compares two values, which it prints if
// the comparison fails. Here is a fact of 3.1; add yours. What has made you look for a mistake is worth a line.
#if !__has_include(<doctest/doctest.h>)
#error "make test needs doctest: apt-get install doctest-dev, or brew install doctest"
#endif
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "quadrature/gaussian_process.h"

#include <doctest/doctest.h>

using namespace bmc;

TEST_CASE("the weights solve Q w = z") {
    const Sobolev covariance;
    const std::vector<Vec3> directions = {{0, 1, 0}, {0.6, 0.8, 0}, {0, 0.28, 0.96}, {-0.8, 0, 0.6}};
    const Matrix q = covariance_matrix(covariance, 0.1, directions);
    const GaussianProcess process(covariance, 0.1, directions);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        double product = 0;
        for (std::size_t j = 0; j < directions.size(); ++j) product += q(i, j) * process.weights[j];
        CHECK(product == doctest::Approx(process.z[i]).epsilon(1e-12));  // a double has some 16 digits
    }
}
