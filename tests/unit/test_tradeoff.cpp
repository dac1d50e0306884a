#include "experiments/tradeoff.h"
#include "test.h"

TEST_CASE("the seconds of a rule are those of all its steps, without z by a sum") {
    CHECK(RuleCost{10, {{"draw", 1}, {"Q", 2}, {"factor", 4}}, 100}.seconds() == 7);
}

// 50,000 covariances for each sample take longer than one elliptic integral does.
TEST_CASE("z by a sum over 50,000 directions takes longer than all steps of a rule") {
    const RuleCost cost = rule_cost(20);
    CHECK(cost.steps.size() == 5);
    CHECK(cost.z_by_sum > cost.seconds());
}
