#include "quadrature/covariance.h"
#include "test.h"

constexpr auto sobolev = CovarianceFamily::sobolev, squared_exponential = CovarianceFamily::squared_exponential;

// Names the place of a covariance that is only added to the table, and holds M and z of all of them to their k.
TEST_CASE("the M and z of every covariance with a name agree with its k") {
    for (std::size_t family = 0; family < std::size(covariance_names); ++family) {
        const auto covariance = make_covariance(static_cast<CovarianceFamily>(family), 1.5);
        INFO(std::string(covariance_names[family]));
        for (const double b : {0.01, 0.7, 2.0}) {
            CAPTURE(b);
            double mean = 0;
            for (double h = 0.5e-4; h < 1; h += 1e-4) mean += 1e-4 * covariance->k(2 * h * b);
            CHECK(relative(covariance->cap_mean(b), mean) < 1e-6);
        }
        for (const double cosine : {0.0, 0.3, 1.0})
            CHECK_MESSAGE(relative(covariance->z(cosine), covariance->Covariance::z(cosine)) < 4e-15, cosine);
        CHECK(relative(covariance->zz(), covariance->Covariance::zz()) < 4e-15);
        const bool takes_smoothness = covariance_names[family] == std::string("sobolev");
        for (const double extreme : {takes_smoothness ? min_smoothness : min_length_scale,
                                     takes_smoothness ? max_smoothness : max_length_scale}) {
            const auto k = make_covariance(static_cast<CovarianceFamily>(family), extreme);
            for (double b = 1e-30; b <= 2; b *= 2)  // k falls, and no digits cancel in its mean
                CHECK_MESSAGE((k->k(2 * b) <= k->cap_mean(b) && k->cap_mean(b) <= k->k(0)), b);
        }
    }
}

// The table was made from the definition of z, in 40 digits: it shares nothing with the product's formulas.
TEST_CASE("z and zz agree with 20 digits of quadrature to 2e-15, or 1e-14 at l = 0.05") {
    const char* const tables[] = {
#include "hemisphere_integrals.txt"
    };
    const auto rows = rows_of(tables[0]);
    REQUIRE(rows.size() == 1 + 13);
    for (std::size_t row = 1; row < rows.size(); ++row) {
        const std::string name = rows[row][0];
        REQUIRE((name == "sobolev" || name == "sobolev_cosine" || name == "squared_exponential"));
        const Known known = name == "sobolev_cosine" ? Known::cosine : Known::nothing;
        const double parameter = std::stod(rows[row][1]);
        const auto covariance =
            make_covariance(name == "squared_exponential" ? squared_exponential : sobolev, parameter, known);
        for (std::size_t i = 2; i < 2 + 12; ++i) {
            const double ours = rows[0][i] == "zz" ? covariance->zz() : covariance->z(std::stod(rows[0][i]));
            INFO(name, " ", parameter, ": ", rows[0][i]);
            CHECK(relative(ours, std::stod(rows[row].at(i))) <= (parameter == 0.05 ? 1e-14 : 2e-15));
        }
    }
}

TEST_CASE("parameters and known parts that a covariance cannot have are refused") {
    for (const double s : {1.0, nan_value}) CHECK_THROWS_AS_MESSAGE(GeneralSobolev{s}, std::invalid_argument, s);
    for (const double l : {0.0499999, nan_value, infinity})
        CHECK_THROWS_AS_MESSAGE(SquaredExponential{l}, std::invalid_argument, l);
    CHECK_THROWS_WITH(GeneralSobolev(2), "the smoothness must lie from 1.001 to 1.999; it is 2");
    CHECK_THROWS_WITH(SquaredExponential(0), "the length-scale must lie from 0.05 to 1e+06; it is 0");
    CHECK_THROWS_WITH(Sobolev().z(1.25), "cos(theta) must lie between 0 and 1; it is 1.25");
    for (const CovarianceFamily family : {sobolev, squared_exponential}) {
        for (const double cosine : {-1e-300, std::nextafter(1, 2), nan_value})
            CHECK_THROWS_AS_MESSAGE(make_covariance(family, 1.4)->z(cosine), std::invalid_argument, cosine);
        CHECK_THROWS_AS(make_covariance(family, 1.4, Known::cosine), std::invalid_argument);
    }
}
