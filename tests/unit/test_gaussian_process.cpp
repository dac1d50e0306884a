#include "quadrature/gaussian_process.h"
#include "test.h"

// Q = [a b; b a], whose inverse is [a -b; -b a] / (a^2 - b^2). The tolerances are for differences of like numbers.
TEST_CASE("weights, error and inverse for two samples are those of a 2 x 2 matrix") {
    for (const Known known : {Known::nothing, Known::cosine}) {
        CAPTURE(name_of(known, known_names));
        const auto covariance = make_covariance(CovarianceFamily::sobolev, 1.5, known);
        const Covariance& k = *covariance;
        const GaussianProcess process(k, 0.1, {{0, 1.0000001, 0}, {0.6, 0.8, 0}});  // as rounding may lengthen it
        const double r = length(process.directions[0] - Vec3{0.6, 0.8, 0}), a = 8.0 / 3 + 0.01, b = 8.0 / 3 - r;
        const double z0 = k.z(1), z1 = k.z(0.8), determinant = a * a - b * b;
        const double w0 = (a * z0 - b * z1) / determinant, w1 = (a * z1 - b * z0) / determinant;
        const double v = k.zz() - z0 * w0 - z1 * w1;
        const double amplitude = std::sqrt((a * (1 + 9) - 2 * b * 3) / determinant / 2);  // Y = (1, 3)
        CHECK(process.z == std::vector<double>{z0, z1});
        CHECK(relative(process.weights[0], w0) < 2e-14);
        CHECK(relative(process.weights[1], w1) < 2e-14);
        CHECK(relative(process.integral({1, 3}), w0 + 3 * w1) < 2e-14);
        CHECK(relative(process.variance, v) < 1e-12);
        CHECK(relative(process.amplitude({1, 3}), amplitude) < 2e-14);
        CHECK(relative(process.error_bar({1, 3}), amplitude * std::sqrt(v)) < 1e-12);
        CHECK(relative(process.inverse_covariance()(0, 1), -b / determinant) < 2e-14);
    }
}

TEST_CASE("amplitude and error bar are in proportion to the values, from 1e-140 to 1e150") {
    const GaussianProcess process(Sobolev(), 0.1, {{0, 1, 0}, {0.6, 0.8, 0}});
    for (const double size : {1e-140, 1e150}) {
        CAPTURE(size);
        for (const double each : {size, -size})
            CHECK(relative(process.amplitude({each, 3 * each}) / size, process.amplitude({1, 3})) < 1e-14);
        CHECK(relative(process.error_bar({size, 0}) / size, process.error_bar({1, 0})) < 1e-14);
    }
    CHECK(process.amplitude({0, 0}) == 0);
}

TEST_CASE("a process refuses what is no sample set, and values that do not belong to it") {
    const auto refusal = [](double noise, const std::vector<Vec3>& directions) {
        return message_of([&] { GaussianProcess(Sobolev(), noise, directions); });
    };
    CHECK(refusal(0.01, {}) == "a Gaussian process needs at least one direction");
    CHECK(refusal(0.01, {{1, -1e-12, 0}}) == Containing{"cos(theta) must lie between 0 and 1; it is -9.99"});
    CHECK(refusal(-1e-12, {{0, 1, 0}}) == "the noise must be at least 0; it is -1e-12");
    CHECK(refusal(infinity, {{0, 1, 0}}) == "the noise must be at least 0; it is inf");
    CHECK(refusal(0, {{0, 1, 0}, {0, 1, 0}}) == Containing{"is not positive definite"});
    const GaussianProcess process(Sobolev(), 0.01, some_directions(3));
    CHECK_THROWS_WITH(process.integral({1, 2}), "a process of 3 directions was given 2 values");
    CHECK_THROWS_AS(process.amplitude({1, 2, 3, 4}), std::logic_error);
}

// Of one direction and no noise z^T Q^-1 z is z^2 / k(0).
TEST_CASE("a variance that would be negative is 0, and an error unknown below a part in 10^12 of zz") {
    struct Prior : Sobolev {
        double left;
        explicit Prior(double part) : left(part) {}
        double zz() const override { return (1 + left) * z(1) * z(1) / k(0); }
    };
    CHECK(GaussianProcess(Prior(-0.5), 0, {{0, 1, 0}}).variance == 0);
    for (const double left : {0.9e-12, 1.1e-12})
        CHECK(std::isnan(GaussianProcess(Prior(left), 0, {{0, 1, 0}}).error_bar({1})) == (left < 1e-12));
}

// Two samples: Q = [a b; b a], whose inverse and determinant are elementary.
TEST_CASE("the log evidence is the density's logarithm with the best amplitude") {
    const GaussianProcess process(Sobolev(), 0.1, {{0, 1, 0}, {0.6, 0.8, 0}});
    const double a = 8.0 / 3 + 0.01, b = 8.0 / 3 - std::sqrt(0.4), determinant = a * a - b * b;
    const double form = (a * (1 + 9) - 2 * b * 3) / determinant;  // Y = (1, 3)
    CHECK(std::fabs(process.log_evidence({1, 3}) - (-std::log(form / 2) - 0.5 * std::log(determinant))) < 1e-14);
}
