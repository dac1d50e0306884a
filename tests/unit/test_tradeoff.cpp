#include "experiments/tradeoff.h"
#include "test.h"

// Monte Carlo: 1600 samples of (1 + 1) us / 100 = 32 us an integral; the rule: 15 us once and 1 us an integral. The
// last stage, z by a sum, is for comparison only.
TEST_CASE("a rule pays off when Monte Carlo at equal error has taken longer") {
    const IntegralCost row{100, 0.4, 0.1, 0, {1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 1e-6, 9}};
    CHECK(relative(row.equivalent_mc_samples(), 1600) < 1e-14);
    CHECK(relative(row.rule_seconds(), 15e-6) < 1e-14);
    CHECK(relative(row.integrals_to_pay_off(), 15.0 / 31) < 1e-14);
}

// cos(theta) has the variance 1/12 under the uniform density.
TEST_CASE("the error of Monte Carlo is that of its variance, which Bayesian Monte Carlo beats") {
    const Integrand cosine{"", "", [](Vec3 w) { return w.y; }, pi};
    const std::vector<IntegralCost> rows = integral_costs(cosine, 1, false), others = integral_costs(cosine, 2, false);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        CHECK(relative(rows[i].mc_error, 2 * pi * std::sqrt(1.0 / 12 / static_cast<double>(rows[i].samples))) < 1e-9);
        CHECK((rows[i].bmc_error < 0.7 * rows[i].mc_error && rows[i].bmc_error != others[i].bmc_error));
        CHECK(std::fabs(rows[i].bmc_error - others[i].bmc_error) < 6 * rows[i].bmc_error_uncertainty);
    }
}
