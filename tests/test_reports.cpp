#include "experiments/reports.h"

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

namespace {

// The rows of a report that are not comments, as words.
std::vector<std::vector<std::string>> rows_of(const std::string& report) {
    std::vector<std::vector<std::string>> rows;
    std::istringstream lines(report);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::istringstream words(line);
        rows.emplace_back();
        for (std::string word; words >> word;) rows.back().push_back(word);
    }
    return rows;
}

}  // namespace

TEST_CASE("a rule is reported as one row of x, y, z and weight for each direction") {
    Random random(1, 0);
    const QuadratureRule rule = bayesian_rule(Sobolev(), 0.01, uniform_directions(12, random));
    const auto rows = rows_of(rule_report(rule));
    REQUIRE(rows.size() == 12);
    for (std::size_t i = 0; i < 12; ++i) {
        REQUIRE(rows[i].size() == 4);
        CHECK(std::fabs(std::stod(rows[i][1]) - rule.directions[i].y) < 1e-5);
        CHECK(std::fabs(std::stod(rows[i][3]) - rule.weights[i]) < 1e-5);
    }
}

TEST_CASE("an error table is reported as numbers only") {
    const ErrorRow row{20, 0.25, 0.0625, 0.125, 0.5};
    const auto rows = rows_of(error_report(practice_integrands()[1], {row}));
    REQUIRE(rows.size() == 1);
    CHECK(rows[0] == std::vector<std::string>{"20", "0.25", "0.0625", "0.125", "4", "320", "0.5"});
}
