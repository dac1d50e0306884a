#include "experiments/error_table.h"
#include "test.h"

static const Integrand cosine_integrand{"cos(theta)", [](Vec3 w) { return w.y; }, pi};

TEST_CASE("an error of rounding counts as none, a larger one counts, however small") {
    ErrorSettings settings;
    settings.mc_estimates = 100;
    settings.bmc_estimates = 1;
    for (const double off : {0.0, 2e-13, 5e-12}) {
        const Integrand constant{"", [](Vec3) { return 1.0; }, (1 + off) * 2 * pi};
        CHECK_MESSAGE((error_rows({constant}, 30, settings)[0].mc.mean > 0) == (off > 1e-12), off);
    }
}

TEST_CASE("a line of the table has four digits, and nan for what has no meaning") {
    ErrorRow row{10};
    for (const double error : {0.123456, 0.223456}) row.mc.add(error);
    const auto check = [&](Placement placement, const std::string& line) {
        CHECK(rows_of(error_report(cosine_integrand, {row}, placement)) == rows_of(line));
    };
    check({}, "10 0.1735 0.05 nan nan nan nan nan");
    row.bmc.add(0.0867280);
    row.predicted.add(0.01);
    check({PointSet::random, Density::cosine}, "10 0.1735 0.05 0.08673 nan 0.01 2 40");
    check({PointSet::stratified}, "10 0.1735 0.05 0.08673 nan 0.01 2 nan");
    row.bmc.add(0.0867280 * (1 + 1e-14));  // which differ by rounding
    check({PointSet::fibonacci, Density::cosine}, "10 0.1735 0.05 0.08673 0 0.01 2 nan");
}

// With b = log 2 and x = 0, b, 2b the slope is (y2 - y0) / 2b. A relative error of 0.1 of each mean leaves it with the
// error sqrt(2) 0.1 / 2b = 0.102.
TEST_CASE("three rows or more tell the slopes, with their standard errors from those of the rows") {
    std::vector<ErrorRow> rows;
    for (const auto& [n, mc] : {std::pair(1, 1.0), {2, 1.0}, {4, 0.25}}) {
        CHECK(!contains(error_report(cosine_integrand, rows, {}), "slope"));
        rows.push_back({static_cast<std::size_t>(n)});
        for (const double luck : {0.9, 1.1}) {
            rows.back().mc.add(luck * mc);
            rows.back().bmc.add(luck * 3 * std::pow(n, -1.25));
        }
    }
    CHECK(error_report(cosine_integrand, rows, {}) == Containing{": mc -1.000 +- 0.102, bmc -1.250 +- 0.102\n"});
    rows[0].bmc = rows[1].bmc = {};
    CHECK(error_report(cosine_integrand, rows, {}) == Containing{": mc -1.000 +- 0.102, bmc nan\n"});
}

TEST_CASE("a list of samples is numbers from 1 to 4096 between commas") {
    std::vector<std::size_t> samples{1};
    Arguments arguments;
    add_sample_list(arguments, samples);
    for (const std::string list : {"", "1,", ",1", "0", "4097", "1, 2"})
        CHECK_THROWS_AS_MESSAGE(parse({"--samples=" + list}, arguments), std::invalid_argument, list);
    parse({"--samples=1,4096"}, arguments);
    CHECK(samples == std::vector<std::size_t>{1, 4096});
}
