#include "experiments/reports.h"
#include "test.h"

// Two samples: Q = [a b; b a], whose inverse and determinant are elementary.
TEST_CASE("the log evidence is the density's logarithm with the best amplitude") {
    const GaussianProcess process(Sobolev(), 0.1, {{0, 1, 0}, {0.6, 0.8, 0}});
    const double a = 8.0 / 3 + 0.01, b = 8.0 / 3 - std::sqrt(0.4), determinant = a * a - b * b;
    const double form = (a * (1 + 9) - 2 * b * 3) / determinant;  // Y = (1, 3)
    CHECK(std::fabs(log_evidence(process, {1, 3}) - (-std::log(form / 2) - 0.5 * std::log(determinant))) < 1e-14);
}
