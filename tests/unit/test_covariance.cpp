#include "quadrature/covariance.h"

#include "test.h"

TEST_CASE("z and zz agree with independent 40-digit quadrature to 2e-15, to 2e-14 for length-scales below 0.1") {
    std::ifstream in("tests/unit/hemisphere_integrals.txt");  // by means that share nothing with the formulas here
    std::ostringstream file;
    file << in.rdbuf();
    const auto rows = rows_of(file.str());
    REQUIRE(rows.size() == 1 + 13);
    for (std::size_t row = 1; row < rows.size(); ++row) {
        const bool exponential = rows[row][0] == "squared_exponential";
        const Known known = rows[row][0] == "sobolev_cosine" ? Known::cosine : Known::nothing;
        const double parameter = std::stod(rows[row][1]);
        const auto covariance =
            make_covariance(exponential ? CovarianceFamily::squared_exponential : CovarianceFamily::sobolev, parameter);
        REQUIRE(rows[row].size() == 2 + 12);
        for (std::size_t i = 2; i < 2 + 12; ++i) {
            const double ours =
                rows[0][i] == "zz" ? covariance->integral_of_z(known) : covariance->z(std::stod(rows[0][i]), known);
            INFO(rows[row][0], " ", parameter, ": ", rows[0][i]);
            CHECK(relative(ours, std::stod(rows[row][i])) <= (exponential && parameter < 0.1 ? 2e-14 : 2e-15));
        }
    }
}

TEST_CASE("a covariance without a closed form for the known part refuses it") {
    const Known known = Known::cosine;
    CHECK_THROWS_AS(Sobolev(1.4).z(0.5, known), std::invalid_argument);
    CHECK_THROWS_AS(Sobolev(1.4).integral_of_z(known), std::invalid_argument);
    CHECK_THROWS_AS(SquaredExponential().z(0.5, known), std::invalid_argument);
}

TEST_CASE("k has its defining values") {
    CHECK(std::fabs(Sobolev()(0) - 8.0 / 3) < 1e-15);
    CHECK(std::fabs(Sobolev()(2.25) - (8.0 / 3 - 1.5)) < 1e-15);
    CHECK(std::fabs(Sobolev(1.25)(3) - (std::pow(2, 1.5) / 1.25 - std::pow(3, 0.25))) < 1e-15);
    CHECK(SquaredExponential(0.5)(0) == 1);
    CHECK(std::fabs(SquaredExponential(0.5)(0.75) - std::exp(-1.5)) < 1e-16);
}

TEST_CASE("parameters outside their domain are refused with their value") {
    for (double s : {2.0, -1.5, nan_value, infinity}) CHECK_THROWS_AS(Sobolev{s}, std::invalid_argument);
    for (double l : {0.0, -1.0, nan_value, infinity}) CHECK_THROWS_AS(SquaredExponential{l}, std::invalid_argument);
    CHECK_THROWS_WITH(Sobolev().z(1.25), "an elevation cosine must be at most 1; it is 1.25");
    CHECK_THROWS_WITH(Sobolev().z(-0.5), "an elevation cosine must be at least 0; it is -0.5");
    CHECK_THROWS_WITH(SquaredExponential().z(-1e-300), "an elevation cosine must be at least 0; it is -1e-300");
    CHECK_THROWS_WITH(Sobolev(1), "the smoothness must lie between 1 and 2, both excluded; it is 1");
    CHECK_THROWS_WITH(SquaredExponential(0.04999999), "the length-scale must be at least 0.05; it is 0.04999999");
    CHECK_THROWS_AS(SquaredExponential().z(nan_value), std::invalid_argument);
}
