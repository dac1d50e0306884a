#include "quadrature/quadrature.h"

#include "test.h"

namespace {

// Lipschitz but with a kink: what radiance looks like to a quadrature.
double kinked(Vec3 w) { return w.y * std::fabs(w.x - 0.2); }

double kinked_integral() {
    double sum = 0;
    for (const Vec3& direction : fibonacci_directions(1000000)) sum += kinked(direction);
    return 2 * pi / 1e6 * sum;
}

}  // namespace

TEST_CASE("one sample has the closed form w = z / (k(0) + noise^2), V = zz - z w") {
    const Sobolev covariance;
    const GaussianProcess process(covariance, 0.5, {normalize({0.3, 0.7, 0.1})});
    const double z = covariance.z(process.directions()[0].y), w = z / (8.0 / 3 + 0.25);
    CHECK(std::fabs(process.weights()[0] / w - 1) < 1e-15);
    CHECK(std::fabs(process.variance() - (covariance.integral_of_z() - z * w)) < 1e-13);
    CHECK(std::fabs(process.integral({2}) - 2 * w) < 1e-14);
    CHECK(std::fabs(process.amplitude({2}) - 2 / std::sqrt(8.0 / 3 + 0.25)) < 1e-15);
    CHECK(std::fabs(process.standard_error({2}) - process.amplitude({2}) * std::sqrt(process.variance())) < 1e-15);
}

TEST_CASE("85 to 99.9 percent of the errors on a kinked integrand lie within two predicted standard errors") {
    const double truth = kinked_integral();
    for (const Known known : {Known::nothing, Known::cosine})
        for (std::size_t n : {20u, 40u, 80u}) {
            int inside = 0;
            for (std::uint64_t set = 0; set < 300; ++set) {
                Random random(12, 1000 * n + set);
                const Placement placement = known == Known::nothing ? Placement::uniform : Placement::cosine;
                const GaussianProcess process(Sobolev(), 0.01, place_directions(placement, n, random).directions,
                                              known);
                std::vector<double> values;
                for (const Vec3& w : process.directions()) values.push_back(kinked(w) / known_part(known, w));
                inside += std::fabs(process.integral(values) - truth) <= 2 * process.standard_error(values);
            }
            CHECK(inside >= 0.85 * 300);
            CHECK(inside <= 0.999 * 300);
        }
}

TEST_CASE("the log evidence is the density's logarithm with the best amplitude") {
    // Two samples: Q = [a b; b a], whose inverse and determinant are elementary.
    const std::vector<Vec3> directions{{0, 1, 0}, normalize({1, 1, 0})};
    const GaussianProcess process(Sobolev(), 0.1, directions);
    const double a = 8.0 / 3 + 0.01, b = 8.0 / 3 - length(directions[0] - directions[1]), det = a * a - b * b;
    const double form = (a * (1 + 9) - 2 * b * 3) / det;  // Y = (1, 3)
    CHECK(std::fabs(process.amplitude({1, 3}) - std::sqrt(form / 2)) < 1e-14);
    CHECK(std::fabs(process.log_evidence({1, 3}) - (-std::log(form / 2) - 0.5 * std::log(det))) < 1e-14);
}

TEST_CASE("a process refuses what is no sample set, and values that do not belong to it") {
    CHECK_THROWS_AS(GaussianProcess(Sobolev(), 0.01, {}), std::invalid_argument);
    CHECK_THROWS_WITH(GaussianProcess(Sobolev(), 0.01, {{1, -1e-12, 0}}),
                      "a direction lies below the horizon: its y is -1e-12");
    CHECK_THROWS_WITH(GaussianProcess(Sobolev(), -1e-12, {{0, 1, 0}}), "the noise must be at least 0; it is -1e-12");
    for (const double noise : {nan_value, infinity})
        CHECK_THROWS_AS(GaussianProcess(Sobolev(), noise, {{0, 1, 0}}), std::invalid_argument);
    const GaussianProcess process(Sobolev(), 0.01, random_directions(3, 4));
    CHECK_THROWS_WITH(process.integral({1, 2}), "a Gaussian process of 3 directions was given 2 values");
    CHECK_THROWS_AS(process.standard_error({1, 2, 3, 4}), std::invalid_argument);
}

TEST_CASE("a direction that rounding has made longer than 1 has the z of the pole") {
    for (const Known known : {Known::nothing, Known::cosine})
        CHECK(z_of(Sobolev(), {{0, 1.0000009, 0}}, known)[0] == z_of(Sobolev(), {{0, 1, 0}}, known)[0]);
    CHECK(z_of(SquaredExponential(), {{0, 1.0000009, 0}})[0] == z_of(SquaredExponential(), {{0, 1, 0}})[0]);
}
