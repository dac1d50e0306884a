#include "quadrature/covariance.h"
#include "quadrature/quadrature.h"
#include "test.h"

constexpr auto sobolev = CovarianceFamily::sobolev, squared_exponential = CovarianceFamily::squared_exponential;

// z by its definition: 2 pi times the mean of k p over many directions.
static double z_by_definition(const Covariance& covariance, double cosine, Known known) {
    constexpr std::size_t n = 40000;
    const Vec3 here{std::sqrt(1 - cosine * cosine), cosine, 0};
    double sum = 0;
    for (const Vec3& w : fibonacci_directions(n)) sum += known_part(known, w) * covariance.k(squared_distance(here, w));
    return 2 * pi / n * sum;
}

TEST_CASE("covariances and known parts have names") { CHECK((names_all(covariance_names) && names_all(known_names))); }

TEST_CASE("k is C - r^(2s - 2), C = 2^(2s - 1) / s, or exp(-r^2 / 2 l^2)") {
    for (const double r : {0.0, 1e-8, 0.3, 1.0, 1.9, 2.0}) {
        for (const double s : {1.001, 1.25, 1.5, 1.75, 1.999}) {
            const double k = std::pow(2, 2 * s - 1) / s - std::pow(r, 2 * s - 2);
            CHECK(std::fabs(Covariance(sobolev, s).k(r * r) - k) < 4e-15);  // roundings of numbers up to 4
        }
        for (const double l : {0.05, 0.5, 1.0, 1.5, 1e6}) {
            const double k = std::exp(-r * r / (2 * l * l));
            CHECK(std::fabs(Covariance(squared_exponential, l).k(r * r) - k) <= 2e-13 * k);  // of an exponent up to 800
        }
    }
    CHECK(Covariance().k(0.25) == Covariance(sobolev, 1.5).k(0.25));
}

// hemisphere_integrals.py made that table by means that share nothing with the product's formulas.
TEST_CASE("z and zz agree with 20 digits of quadrature to 2e-15, at the length-scale 0.05 to 1e-14") {
    std::ostringstream file;
    file << std::ifstream("tests/unit/hemisphere_integrals.txt").rdbuf();
    const auto rows = rows_of(file.str());
    REQUIRE(rows.size() == 1 + 13);
    for (std::size_t row = 1; row < rows.size(); ++row) {
        const Known known = rows[row][0] == "sobolev_cosine" ? Known::cosine : Known::nothing;
        const double parameter = std::stod(rows[row][1]);
        const Covariance covariance(rows[row][0] == "squared_exponential" ? squared_exponential : sobolev, parameter);
        for (std::size_t i = 2; i < 2 + 12; ++i) {
            const double ours = rows[0][i] == "zz" ? covariance.zz(known) : covariance.z(std::stod(rows[0][i]), known);
            INFO(rows[row][0], " ", parameter, ": ", rows[0][i]);
            CHECK(relative(ours, std::stod(rows[row].at(i))) <= (parameter == 0.05 ? 1e-14 : 2e-15));
        }
    }
}

// The sums err most at the rim, where a step of the lattice, 2.5e-5 high, is all in or all out: by 3e-5 of themselves,
// and by 3e-3 at l = 0.05, since few directions count.
TEST_CASE("z is 2 pi times the mean of k p over H, in any direction, and zz that of z p") {
    const auto agree = [](const Covariance& covariance, Known known, double most) {
        double zz = 0;
        for (double cosine = 1.0 / 8000; cosine < 1; cosine += 1.0 / 4000)
            zz += 2 * pi / 4000 * covariance.z(cosine, known) * known_part(known, {0, cosine, 0});
        CHECK(relative(covariance.zz(known), zz) < most);
        for (const double cosine : {0.0, 0.02, 0.4, 0.7, 0.95, 1.0})
            CHECK(relative(covariance.z(cosine, known), z_by_definition(covariance, cosine, known)) < most);
    };
    for (const double s : {1.05, 1.5, 1.85}) agree(Covariance(sobolev, s), Known::nothing, 4e-5);
    agree(Covariance(), Known::cosine, 4e-5);
    for (const double l : {0.05, 1.5, 2.0})
        agree(Covariance(squared_exponential, l), Known::nothing, l < 1 ? 4e-3 : 4e-5);
}

// Each side errs by up to 2e-15; from one parameter to the next z changes by less.
TEST_CASE("the closed form of z at s = 3/2 and the integral over caps beside it agree to 4e-15") {
    for (const double s : {std::nextafter(1.5, 1), std::nextafter(1.5, 2)})
        for (int i = 0; i <= 500; ++i)
            CHECK(relative(Covariance(sobolev, s).z(i / 500.0), Covariance().z(i / 500.0)) < 4e-15);
}

TEST_CASE("parameters, cosines and known parts that a covariance cannot have are refused") {
    for (const double s : {1.0, 2.0, nan_value}) CHECK_THROWS_AS(Covariance(sobolev, s), std::invalid_argument);
    for (const double l : {0.0499999, nan_value, infinity})
        CHECK_THROWS_AS(Covariance(squared_exponential, l), std::invalid_argument);
    CHECK_THROWS_WITH(Covariance(sobolev, 2), "the smoothness must lie between 1 and 2; it is 2");
    CHECK_THROWS_WITH(Covariance(squared_exponential, 0), "the length-scale must be at least 0.05; it is 0");
    CHECK_THROWS_WITH(Covariance().z(1.25), "cos(theta) must lie between 0 and 1; it is 1.25");
    for (const double cosine : {-1e-300, std::nextafter(1, 2), nan_value})
        CHECK_THROWS_AS(Covariance(squared_exponential, 1.5).z(cosine), std::invalid_argument);
    for (const Covariance& covariance : {Covariance(sobolev, 1.4), Covariance(squared_exponential, 1.5)}) {
        CHECK_THROWS_AS(covariance.z(0.5, Known::cosine), std::invalid_argument);
        CHECK_THROWS_AS(covariance.zz(Known::cosine), std::invalid_argument);
    }
}
