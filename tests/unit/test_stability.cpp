#include "experiments/stability.h"

#include "experiments/exact_weights.h"
#include "quadrature/gaussian_process.h"

#include <doctest/doctest.h>

#include <cfloat>
#include <cmath>

namespace {

// Weights Q^-1 z by Gaussian elimination in double-double arithmetic; Q and z as they are, in doubles.
std::vector<double> wide_weights(const Covariance& covariance, double noise, const std::vector<Vec3>& directions) {
    const std::size_t n = directions.size();
    const Matrix q = symmetric(covariance_matrix(covariance, noise, directions));
    const std::vector<double> z = hemisphere_integrals(covariance, directions);
    std::vector<std::vector<DoubleDouble>> a(n, std::vector<DoubleDouble>(n + 1));
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) a[i][j] = q(i, j);
        a[i][n] = z[i];
    }
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = k + 1; i < n; ++i) {
            const DoubleDouble factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j <= n; ++j) a[i][j] = a[i][j] - factor * a[k][j];
        }
    std::vector<double> weights(n);
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t j = i + 1; j < n; ++j) a[i][n] = a[i][n] - a[i][j] * a[j][n];
        a[i][n] = a[i][n] / a[i][i];
        weights[i] = a[i][n].high;
    }
    return weights;
}

StabilityRow examine_one(SampleSet set, const Model& model, double noise) {
    return examine(set, 100, model, {noise}).front();
}

}  // namespace

TEST_CASE(
    "weights agree with double-double arithmetic as far as the condition number allows, by solve and by inverse") {
    const Sobolev rough;
    const SquaredExponential smooth(1);
    for (const SampleSet set : {SampleSet::random, SampleSet::duplicates, SampleSet::equator, SampleSet::cluster})
        for (const Covariance* covariance :
             {static_cast<const Covariance*>(&rough), static_cast<const Covariance*>(&smooth)})
            for (const double noise : {1.0, 1e-2, 1e-4}) {
                const std::vector<Vec3> directions = sample_set(set, 40);
                const std::vector<double> exact = wide_weights(*covariance, noise, directions);
                const GaussianProcess process(*covariance, noise, directions);
                const Matrix inverse = process.inverse_covariance();
                const Matrix q = symmetric(covariance_matrix(*covariance, noise, directions));
                const double condition = row_sum_norm(q) * row_sum_norm(inverse);
                double largest = 0, by_solve = 0, by_inverse = 0, z_norm = 0;
                for (std::size_t i = 0; i < 40; ++i) {
                    double weight = 0;
                    for (std::size_t j = 0; j < 40; ++j) weight += inverse(i, j) * process.z()[j];
                    z_norm = std::max(z_norm, process.z()[i]);
                    largest = std::max(largest, std::fabs(exact[i]));
                    by_solve = std::max(by_solve, std::fabs(process.weights()[i] - exact[i]));
                    by_inverse = std::max(by_inverse, std::fabs(weight - exact[i]));
                }
                CAPTURE(name_of(set, sample_set_names));
                CAPTURE(noise);
                // A backward stable solution is wrong by about eps times the condition number. So is each column of the
                // inverse, relative to itself; where A is nearly singular, the columns are far larger than the weights.
                CHECK(by_solve < 4 * DBL_EPSILON * condition * largest);
                CHECK(by_inverse < 4 * DBL_EPSILON * condition * row_sum_norm(inverse) * z_norm);
            }
}

// Where the covariances of doubles are exact, Gaussian elimination with 32 digits has the same weights: k = 8/3 - r
// with r = 0 or 1 (8/3 is rounded by 1.5e-16), z by its closed form (to 5e-16).
TEST_CASE("exact weights are those of elimination with 32 digits, but for the rounding of Q and z") {
    const std::vector<Vec3> directions{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}};
    for (const Model& model : {Model(CovarianceFamily::sobolev, 1.5), Model(CovarianceFamily::sobolev, 1.25),
                               Model(CovarianceFamily::squared_exponential, 0.5)})
        for (const double noise : {1.0, 0.5}) {
            const GaussianProcess process(*model.covariance, noise, directions);
            const std::vector<double> weights = wide_weights(*model.covariance, noise, directions);
            CHECK(ExactWeights(model, directions).error_of(weights, noise, process.cholesky()) < 1e-14);
        }
}

// Solving Q w = z with 60 digits, Q and z from the directions, gave these, to the digits that they are written with.
TEST_CASE("the error of the weights is that from the directions, as was measured with 60 digits") {
    const Model rough(CovarianceFamily::sobolev, 1.5), smooth(CovarianceFamily::squared_exponential, 1);
    CHECK(std::fabs(examine_one(SampleSet::cluster, rough, 1e-2).weight_error / 1.5e-9 - 1) < 0.04);
    CHECK(std::fabs(examine_one(SampleSet::cluster, rough, 1e-4).weight_error / 1.55e-6 - 1) < 0.004);
    CHECK(std::fabs(examine_one(SampleSet::cluster, smooth, 1e-6).weight_error / 9.3e-4 - 1) < 0.006);
}

TEST_CASE("where the factor passes and no digit is right, there are no exact weights") {
    const StabilityRow row = examine_one(SampleSet::random, {CovarianceFamily::squared_exponential, 1}, 0);
    CHECK(!row.refused);
    CHECK(!(row.weight_error < 0.1));
}

TEST_CASE("residual ratios stay below 5 at extremes, LAPACK's limit being 30") {
    constexpr std::size_t n = 100;
    for (const SampleSet set : {SampleSet::random, SampleSet::equator, SampleSet::pole, SampleSet::cluster})
        for (const Model& model :
             {Model(CovarianceFamily::sobolev, 1.5), Model(CovarianceFamily::squared_exponential, 1)})
            for (const double noise : {1.0, 1e-4, 1e-6}) {
                const Matrix q = symmetric(covariance_matrix(*model.covariance, noise, sample_set(set, n)));
                const Cholesky cholesky(q);
                const Matrix &u = cholesky.upper(), inverse = cholesky.inverse();
                Matrix of_factor = q, of_inverse(n, n);
                for (std::size_t i = 0; i < n; ++i)
                    for (std::size_t j = 0; j < n; ++j) {
                        of_inverse(i, j) = i == j;
                        for (std::size_t k = 0; k < n; ++k) {
                            of_factor(i, j) -= u(k, i) * u(k, j);
                            of_inverse(i, j) -= q(i, k) * inverse(k, j);
                        }
                    }
                const double unit = n * DBL_EPSILON * row_sum_norm(q);
                CHECK(row_sum_norm(of_factor) < 5 * unit);
                CHECK(row_sum_norm(of_inverse) < 5 * unit * row_sum_norm(inverse));
            }
}

TEST_CASE("weights by the inverse lose digits that weights by the factor keep, but for one sample") {
    const StabilityRow one = examine(SampleSet::random, 1, {CovarianceFamily::sobolev, 1.5}, {1e-2}).front();
    CHECK(one.weight_error < 1e-15);
    CHECK(one.inverse_error < 1e-15);
    const StabilityRow many = examine_one(SampleSet::equator, {CovarianceFamily::squared_exponential, 1}, 1e-4);
    CHECK(many.inverse_error > 1000 * many.weight_error);
    CHECK(many.inverse_error < 0.01);
}

TEST_CASE("what is singular in double precision is refused, naming the pivot, and works with noise") {
    for (const SampleSet set : {SampleSet::duplicates, SampleSet::pole}) {
        try {
            Cholesky(covariance_matrix(Sobolev(), 0, sample_set(set, 100)));
            FAIL("accepted");
        } catch (const NotPositiveDefinite& error) {
            CHECK(error.index == 1);
        }
        CHECK(examine_one(set, {CovarianceFamily::sobolev, 1.5}, 0).refused);
        CHECK(!examine_one(set, {CovarianceFamily::sobolev, 1.5}, 1e-2).refused);
    }
    // As s tends to 2, k tends to C - r^2, of rank 4: constants and the three coordinates.
    const Model nearly_flat{CovarianceFamily::sobolev, std::nextafter(2, 1)};
    CHECK(examine_one(SampleSet::random, nearly_flat, 0).refused);
    CHECK(!examine_one(SampleSet::random, nearly_flat, 1e-2).refused);
}

TEST_CASE("a long length-scale makes Bayesian Monte Carlo classic: w = 2 pi / (N + noise^2)") {
    for (const double noise : {0.1, 1.0, 10.0}) {
        const GaussianProcess process(SquaredExponential(1e6), noise, sample_set(SampleSet::random, 40));
        // k differs from 1 by r^2 / 2 l^2 < 2e-12, which the condition number N / noise^2 < 4001 amplifies.
        for (const double weight : process.weights())
            CHECK(std::fabs(weight / (2 * portable::pi / (40 + noise * noise)) - 1) < 1e-8);
    }
}

TEST_CASE("much noise makes the weights vanish, as z / noise^2") {
    const GaussianProcess process(Sobolev(), 1e3, sample_set(SampleSet::random, 40));
    // The next term of the series in 1 / noise^2 is smaller by |Q| / noise^2 < 110e-6.
    for (std::size_t i = 0; i < 40; ++i) CHECK(std::fabs(process.weights()[i] / (process.z()[i] * 1e-6) - 1) < 1.1e-4);
}

TEST_CASE("samples that do not see one another have the weight z / (1 + noise^2)") {
    // Four directions 1 apart at l = 0.05: k = e^-200.
    const std::vector<Vec3> directions{{0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}};
    const GaussianProcess process(SquaredExponential(0.05), 0.1, directions);
    for (std::size_t i = 0; i < 4; ++i) CHECK(std::fabs(process.weights()[i] / (process.z()[i] / 1.01) - 1) < 1e-15);
}

TEST_CASE("duplicates share one weight") {
    std::vector<Vec3> directions = sample_set(SampleSet::random, 20);
    const double noise = 0.1;
    const std::vector<double> alone = GaussianProcess(Sobolev(), noise / std::sqrt(2), directions).weights();
    directions.insert(directions.end(), directions.begin(), directions.end());
    const std::vector<double> twice = GaussianProcess(Sobolev(), noise, directions).weights();
    // Two samples with noise variance v are one with v / 2. The condition number is about 1e4.
    for (std::size_t i = 0; i < 20; ++i) {
        CHECK(std::fabs(twice[i] - twice[i + 20]) < 1e-11);
        CHECK(std::fabs(twice[i] + twice[i + 20] - alone[i]) < 1e-11);
    }
}

TEST_CASE("sample sets are what their names say") {
    for (const Vec3& d : sample_set(SampleSet::equator, 10)) CHECK(d.y == 0);
    for (const Vec3& d : sample_set(SampleSet::pole, 10)) CHECK(d.y == 1);
    const std::vector<Vec3> cluster = sample_set(SampleSet::cluster, 10), twice = sample_set(SampleSet::duplicates, 10);
    for (std::size_t i = 0; i < 10; ++i) {
        CHECK(length(cluster[i] - Vec3{0.48, 0.6, 0.64}) < 1.1e-8);
        CHECK(twice[i].x == twice[i / 2 * 2].x);
    }
}
