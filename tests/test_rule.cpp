#include "experiments/rule.h"

#include <doctest/doctest.h>

#include <cmath>

#include "rows_of.h"

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
