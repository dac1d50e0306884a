#include "experiments/tradeoff.h"
#include "scene/desert.h"

#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

TEST_CASE("what a picture costs: the practice's three steps against error correlated between pixels" *
          doctest::test_suite("long")) {
    const std::vector<PictureCost> rows = picture_costs(built_in_environment(), 32, false);
    CHECK(rows.size() == (8 * 2 + 14) * 5);
    const auto find = [&](Method method, std::size_t pool, std::size_t samples) {
        for (const PictureCost& row : rows)
            if (row.settings.method == method && row.settings.pool == pool && row.settings.samples == samples &&
                row.settings.placement == Placement::uniform && row.settings.prior.mean == PriorMean::zero &&
                row.settings.prior.known == KnownPart::nothing)
                return row;
        throw std::runtime_error("no such row");
    };
    CHECK(find(Method::single, 1, 10).correlation > 0.9);
    CHECK(std::fabs(find(Method::pool, 20, 40).correlation) < 0.05);
    for (const std::size_t samples : {std::size_t{20}, std::size_t{40}, std::size_t{160}}) {
        const PictureCost mc = find(Method::mc, 1, samples);
        CHECK(find(Method::pool, 5, samples).rmse < 0.75 * mc.rmse);
        CHECK(find(Method::direct, 1, samples).rmse < 0.75 * mc.rmse);
        CHECK(mc.seconds_per_megapixel == 0);
    }
    // One rule for all pixels: its errors differ from seed to seed by some 35 %, so those of 64 seeds by 4 %.
    const PictureCost single = find(Method::single, 1, 10);
    CHECK(single.rmse_error > 0.02 * single.rmse);
    CHECK(single.rmse_error < 0.1 * single.rmse);
    CHECK(single.brightness > 4 * find(Method::pool, 20, 10).brightness);
    // Monte Carlo's error falls as 1 / sqrt(n); 680 pixels, 4 seeds and 3 channels leave 2 %.
    CHECK(std::fabs(find(Method::mc, 1, 10).rmse / find(Method::mc, 1, 160).rmse / 4 - 1) < 0.05);
}

TEST_CASE("a light that reaches no object is refused") {
    CHECK_THROWS_WITH_AS(picture_costs(EnvironmentMap(1, 1, {0, 0, 0}), 2, false),
                         "the environment lights no object, so there is no error to compare; take another",
                         std::invalid_argument);
}

TEST_CASE("the advice takes no setting whose errors are correlated, and progress grows to 1") {
    Tradeoff tradeoff;
    tradeoff.size = 8;
    tradeoff.timed = false;
    const std::string report = tradeoff.report();
    CHECK(report.find("# RMSE 0.04: --method ") != std::string::npos);
    CHECK(report.find(": --method single") == std::string::npos);
    double last = 0;
    picture_costs(EnvironmentMap(1, 1, {1, 1, 1}), 4, false, [&](double done) {
        CHECK(done > last);
        last = done;
    });
    CHECK(last == 1);
}

TEST_CASE("what an integral costs: a rule pays off when Monte Carlo at equal error is slower") {
    IntegralCost row{100, 0.4, 0.1, {1e-6, 2e-6, 3e-6, 4e-6, 5e-6, 1e-6}};
    CHECK(std::fabs(row.equivalent_mc_samples() - 1600) < 1e-9);
    // Monte Carlo: 1600 samples of (1 + 1) us / 100 = 32 us an integral; the rule: 15 us once and 1 us an integral.
    CHECK(std::fabs(row.integrals_to_pay_off() - 15.0 / 31) < 1e-12);
}

TEST_CASE("measured times are positive where they are asked for" * doctest::test_suite("long")) {
    const std::vector<IntegralCost> rows = integral_costs(practice_integrands()[1], true);
    for (const IntegralCost& row : rows) {
        CHECK(row.seconds.factor > 0);
        CHECK(row.seconds.rule() > row.seconds.factor);
        CHECK(row.bmc_error < row.mc_error);
    }
    for (const PictureCost& row : picture_costs(EnvironmentMap(1, 1, {1, 1, 1}), 2, true))
        CHECK(row.seconds_per_megapixel > 0);
}
