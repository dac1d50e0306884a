#include "experiments/tradeoff.h"
#include "test.h"

#include <numeric>

// 50,000 covariances for each sample take longer than one elliptic integral does.
TEST_CASE("z by a sum over 50,000 directions takes longer than all steps of a rule") {
    const std::vector<double> seconds = rule_seconds(20);
    CHECK(seconds.size() == 6);
    CHECK(seconds.back() > std::accumulate(seconds.begin(), seconds.end() - 1, 0.0));
}
