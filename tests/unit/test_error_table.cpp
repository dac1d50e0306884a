#include "experiments/error_table.h"

#include "test.h"

namespace {

ErrorRow row_of(const Integrand& integrand, std::size_t samples, std::size_t mc_estimates, std::size_t bmc_estimates) {
    ErrorSettings settings;
    settings.samples = {samples};
    settings.mc_estimates = mc_estimates;
    settings.bmc_estimates = bmc_estimates;
    return error_table(integrand, settings).at(0);
}

}  // namespace

// Normal errors: E |error| = sqrt(2 / pi) * 2 pi sqrt(1/12 / n) for cos(theta); the mean of 4000 has a relative
// standard error of 0.756 / sqrt(4000), and 5 of them allow for the normal approximation too.
TEST_CASE("the mean absolute error of Monte Carlo is what its variance says") {
    const double expected = std::sqrt(2 / pi) * 2 * pi * std::sqrt(1.0 / 12 / 40);
    CHECK(relative(row_of(practice_integrands()[1], 40, 4000, 1).mc_error, expected) < 5 * 0.756 / std::sqrt(4000));
}

TEST_CASE("estimates of Bayesian Monte Carlo do not depend on the number of those of Monte Carlo") {
    const ErrorRow many = row_of(practice_integrands()[1], 10, 100, 30),
                   few = row_of(practice_integrands()[1], 10, 3, 30);
    CHECK(few.bmc_error == many.bmc_error);
    CHECK(few.bmc_predicted == many.bmc_predicted);
    CHECK(few.mc_error != many.mc_error);
}

TEST_CASE("an exact estimate has no infinite or undefined gain beside another exact one") {
    CHECK(ErrorRow{10, 0, 0, 0}.gain() == 1);
    CHECK(std::isinf(ErrorRow{10, 1, 0, 0}.gain()));
    CHECK(ErrorRow{10, 3, 2, 0}.gain() == 1.5);
}

// Monte Carlo integrates a constant exactly but for the rounding of its sum.
TEST_CASE("an error of rounding counts as none, a larger one counts, however small") {
    for (const auto& [relative, counts] : {std::pair(0.0, false), {2e-13, false}, {5e-12, true}}) {
        const Integrand off{"", "", [](Vec3) { return 1.0; }, (1 + relative) * 2 * pi};
        CHECK((row_of(off, 30, 100, 1).mc_error > 0) == counts);
    }
}
