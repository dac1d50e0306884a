#include "experiments/tradeoff.h"

#include "test.h"

TEST_CASE("what an integral costs: a rule pays off when Monte Carlo at equal error is slower") {
    IntegralCost row{100, 0.4, 0.1, 0, {1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 1e-6}};
    CHECK(std::fabs(row.equivalent_mc_samples() - 1600) < 1e-9);
    // Monte Carlo: 1600 samples of (1 + 1) us / 100 = 32 us an integral; the rule: 15 us once and 1 us an integral.
    CHECK(std::fabs(row.integrals_to_pay_off() - 15.0 / 31) < 1e-12);
}

TEST_CASE("the error of Monte Carlo is that of its variance, which Bayesian Monte Carlo beats, and times are positive" *
          doctest::test_suite("long")) {
    const std::vector<IntegralCost> rows = integral_costs(practice_integrands()[1], 1, true);
    for (const IntegralCost& row : rows) {
        // cos(theta) has variance 1/12 under the uniform density; the dense quadrature errs by 1e-10.
        const double expected = 2 * pi * std::sqrt(1.0 / 12 / static_cast<double>(row.samples));
        CHECK(std::fabs(row.mc_error / expected - 1) < 1e-9);
        CHECK(row.bmc_error < row.mc_error);
        CHECK(row.bmc_error_uncertainty < 0.2 * row.bmc_error);
        CHECK(row.seconds[2] > 0);
        CHECK(row.rule_seconds() > row.seconds[2]);
    }
    CHECK(integral_costs(practice_integrands()[1], 2, false)[0].bmc_error != rows[0].bmc_error);
}
