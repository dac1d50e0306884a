// Tests of your own, with doctest: a TEST_CASE states a fact, and each CHECK compares two values, which it prints if
// the comparison fails. make test runs them. Here are three facts of 3.1; add yours. What has made you look for a
// mistake once is worth a line.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "quadrature/gaussian_process.h"

#include <doctest/doctest.h>

using namespace bmc;

namespace {
const Sobolev covariance;
const double noise = 0.1;
const std::vector<Vec3> directions = {{0, 1, 0}, {0.6, 0.8, 0}, {0, 0.28, 0.96}, {-0.8, 0, 0.6}};
const std::size_t count = directions.size();
const double rounding = 1e-12;  // numbers here are about 1, and have some 16 digits
}  // namespace

TEST_CASE("U^T U = Q, and U is 0 below its diagonal") {
    const Matrix q = covariance_matrix(covariance, noise, directions), u = Cholesky(q).upper;
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < count; ++j) {
            double product = 0;
            for (std::size_t m = 0; m < count; ++m) product += u(m, i) * u(m, j);
            CHECK(std::fabs(product - q(i, j)) < rounding);
            if (i > j) CHECK(u(i, j) == 0);
        }
}

TEST_CASE("the weights solve Q w = z") {
    const GaussianProcess process(covariance, noise, directions);
    const Matrix q = covariance_matrix(covariance, noise, directions);
    for (std::size_t i = 0; i < count; ++i) {
        double product = 0;
        for (std::size_t j = 0; j < count; ++j) product += q(i, j) * process.weights[j];
        CHECK(std::fabs(product - process.z[i]) < rounding * process.z[i]);
    }
}

TEST_CASE("a matrix that is not positive definite has no factor") {
    Matrix a(2, 2);  // x^T A x is -2 for x = (1, -1)
    a(0, 0) = a(1, 1) = 1, a(0, 1) = a(1, 0) = 2;
    CHECK_THROWS_AS(Cholesky{a}, NotPositiveDefinite);
}
