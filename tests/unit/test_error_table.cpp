#include "experiments/error_table.h"

#include "test.h"

TEST_CASE("the mean absolute error of Monte Carlo is what its variance says") {
    // Normal errors: E |error| = sqrt(2 / pi) * 2 pi sqrt(1/12 / n) for cos(theta); the mean of 4000 has a relative
    // standard error of 0.756 / sqrt(4000), and 5 of them allow for the normal approximation too.
    ErrorSettings settings;
    settings.samples = {40};
    settings.mc_estimates = 4000;
    settings.bmc_estimates = 1;
    const std::vector<ErrorRow> rows = error_table(practice_integrands()[1], settings);
    REQUIRE(rows.size() == 1);
    const double expected = std::sqrt(2 / pi) * 2 * pi * std::sqrt(1.0 / 12 / 40);
    CHECK(std::fabs(rows[0].mc_error / expected - 1) < 5 * 0.756 / std::sqrt(4000));
}

TEST_CASE("estimates of Bayesian Monte Carlo do not depend on the number of those of Monte Carlo") {
    ErrorSettings settings;
    settings.samples = {10};
    settings.bmc_estimates = 30;
    settings.mc_estimates = 100;
    const ErrorRow many = error_table(practice_integrands()[1], settings)[0];
    settings.mc_estimates = 3;
    const ErrorRow few = error_table(practice_integrands()[1], settings)[0];
    CHECK(few.bmc_error == many.bmc_error);
    CHECK(few.bmc_predicted == many.bmc_predicted);
    CHECK(few.mc_error != many.mc_error);
}

TEST_CASE("an exact estimate has no infinite or undefined gain beside another exact one") {
    CHECK(ErrorRow{10, 0, 0, 0}.gain() == 1);
    CHECK(std::isinf(ErrorRow{10, 1, 0, 0}.gain()));
    CHECK(ErrorRow{10, 3, 2, 0}.gain() == 1.5);
}

TEST_CASE("an error of rounding counts as none, a larger one counts, however small") {
    // Monte Carlo integrates a constant exactly but for the rounding of its sum.
    ErrorSettings settings;
    settings.samples = {30};
    settings.bmc_estimates = 1;
    for (const auto& [relative, counts] : {std::pair(0.0, false), {2e-13, false}, {5e-12, true}}) {
        const Integrand off{"", "", [](Vec3) { return 1.0; }, (1 + relative) * 2 * pi};
        CHECK((error_table(off, settings)[0].mc_error > 0) == counts);
    }
}
