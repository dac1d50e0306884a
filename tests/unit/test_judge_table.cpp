#include "judge/judge_table.h"

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "experiments/error_table.h"
#include "rows_of.h"

namespace {

const std::vector<std::size_t> counts{10, 20, 30, 40, 50, 60};

Integrand cosine() { return practice_integrands()[1]; }

TableJudgement judged(const std::vector<InputRow>& rows) { return judge_table(rows, cosine(), {}); }

// A table with so many estimates for a cell, each error multiplied.
std::vector<InputRow> table(std::uint64_t seed, std::size_t mc_estimates, std::size_t bmc_estimates, double mc = 1,
                            double bmc = 1) {
    ErrorSettings settings;
    settings.samples = counts;
    settings.mc_estimates = mc_estimates;
    settings.bmc_estimates = bmc_estimates;
    settings.seed = seed;
    std::vector<InputRow> rows;
    for (const ErrorRow& row : error_table(cosine(), settings))
        rows.push_back({rows.size() + 1, {static_cast<double>(row.samples), mc * row.mc_error, bmc * row.bmc_error}});
    return rows;
}

}  // namespace

TEST_CASE("tables of twenty seeds are within what correct programs do" * doctest::test_suite("long")) {
    int wrong = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) wrong += !judged(table(seed, 100, 10)).fits();
    CHECK(wrong == 0);
}

TEST_CASE("a cell's spread is that of means of 100 and of 10 absolute errors, 7 and 29 % and what is expected's own") {
    const TableJudgement judgement = judged(table(1, 100, 10));
    REQUIRE(judgement.mc.cells.size() == counts.size());
    for (const Cell& cell : judgement.mc.cells) {
        CHECK(cell.spread > 0.07);  // half-normal errors: 0.756 / sqrt(100)
        CHECK(cell.spread < 0.09);
    }
    for (const Cell& cell : judgement.bmc.cells) {
        CHECK(cell.spread > 0.22);
        CHECK(cell.spread < 0.32);
    }
}

TEST_CASE("errors twice as large or half as large are found in their column" * doctest::test_suite("long")) {
    const TableJudgement twice = judged(table(2, 100, 10, 2, 1)), half = judged(table(2, 100, 10, 1, 0.4));
    CHECK(!twice.mc.fits());
    CHECK(twice.bmc.fits());
    CHECK(half.mc.fits());
    CHECK(!half.bmc.fits());
    std::vector<InputRow> rows = table(2, 100, 10);
    for (std::size_t i = 0; i < rows.size(); ++i)  // a sixth, which one cell may be off
        rows[i].numbers[1] = 7.0 / 6 * judged(rows).mc.cells[i].expected;
    const Column sixth = judged(rows).mc;
    CHECK(sixth.scatter() <= sixth.accepted_scatter());
    CHECK(!sixth.fits());
    CHECK(table_report(half).find("# Verdict: not what correct programs do, by BMC.\n") != std::string::npos);
}

TEST_CASE("means of too few estimates scatter, and negative errors are named") {
    const TableJudgement few = judged(table(3, 4, 1));
    CHECK(!few.mc.fits());
    std::vector<InputRow> rows = table(4, 100, 10);
    rows[2].numbers[1] *= -1;
    CHECK(table_report(judged(rows)).find("an error is negative") != std::string::npos);
}

TEST_CASE("a ratio just inside what is accepted fits, and one just outside does not; scatter likewise") {
    Column column{"MC", 100, std::vector<Cell>(16, Cell{1, 1, 0.1})};
    // Four standard deviations of the mean of 16 cells, on the logarithmic scale.
    const double factor = portable::exp(4 * 0.1 / 4);
    const auto all = [&](double here) {
        for (Cell& cell : column.cells) cell.here = here;
        return column;
    };
    CHECK(std::fabs(column.accepted_factor() - factor) < 1e-12);
    CHECK(all(factor * 0.999).fits());
    CHECK(!all(factor * 1.001).fits());
    CHECK(all(1.001 / factor).fits());
    CHECK(!all(0.999 / factor).fits());
    // 16 deviations of s spreads have the mean square s^2: accepted to 1 + 2 sqrt(7 / 16) + 14 / 16.
    const auto scattered = [&](double s) {
        for (std::size_t i = 0; i < 16; ++i)
            column.cells[i].here = portable::pow(1 + (i % 2 == 0 ? s : -s) * 0.1 / 3, 3);
        return column;
    };
    const double most = std::sqrt(1 + 2 * std::sqrt(7.0 / 16) + 14.0 / 16);
    CHECK(scattered(0.999 * most).fits());
    CHECK(!scattered(1.001 * most).fits());
}

TEST_CASE("what makes errors of correct ones is named: a factor, another scale, exchanged columns" *
          doctest::test_suite("long")) {
    const auto report = [](double mc, double bmc) { return table_report(judged(table(5, 100, 10, mc, bmc))); };
    const auto contains = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos;
    };
    CHECK(contains(report(100, 1), "a sum of 100 in place of the mean"));
    CHECK(contains(report(1, 10), "a sum of 10 in place of the mean"));
    CHECK(contains(report(2 * portable::pi, 1), "2 pi too often"));
    CHECK(contains(report(1 / portable::pi, 1), "relative to the integral"));
    CHECK(contains(report(1.2533, 1), "root mean squares"));
    std::vector<InputRow> rows = table(5, 100, 10);
    for (InputRow& row : rows) std::swap(row.numbers[1], row.numbers[2]);
    CHECK(contains(table_report(judged(rows)), "the columns are exchanged"));
    CHECK(!contains(report(1, 1), "Likely"));
}

TEST_CASE("the report has a row for each of the table, and ends in a verdict") {
    const std::string text = table_report(judged(table(1, 100, 10)));
    const auto rows = rows_of(text);
    REQUIRE(rows.size() == counts.size());
    for (const auto& row : rows) CHECK(row.size() == 9);
    CHECK(text.find("# Verdict: within what correct programs do.\n") != std::string::npos);
}

TEST_CASE("an integral without error has none in a correct table") {
    const Integrand constant = practice_integrands()[0];
    const auto mc_fits = [&](double error) { return judge_table({{1, {20, error, 0.2}}}, constant, {}).mc.fits(); };
    CHECK(mc_fits(0));
    CHECK(mc_fits(-4e-16));
    CHECK(!mc_fits(0.01));
}

TEST_CASE("rows that are none of an error table are named") {
    CHECK_THROWS_WITH_AS(judged({{7, {10, 0.1}}}),
                         "line 7: a row should be samples, error of Monte Carlo, error of Bayesian Monte Carlo",
                         std::runtime_error);
    CHECK_THROWS_WITH_AS(judged({{1, {10.5, 0.1, 0.1}}}),
                         "line 1: 10.5 samples; a whole number from 1 to 1000 can be judged", std::runtime_error);
    CHECK_THROWS_WITH_AS(judged({{1, {10, 0.1, 0.1}}, {2, {20, 0.1, 0.1}}, {5, {10, 0.1, 0.1}}}),
                         "line 5: 10 samples a second time; leave one table in the file", std::runtime_error);
    CHECK_THROWS_AS(judged({{1, {0, 0.1, 0.1}}}), std::runtime_error);
    CHECK_THROWS_AS(judged({{1, {1001, 0.1, 0.1}}}), std::runtime_error);
}
