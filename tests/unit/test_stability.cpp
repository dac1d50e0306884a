#include "experiments/stability.h"
#include "test.h"

// Turning changes no distance and no y, so all differences are roundings.
TEST_CASE("the weights' error is the largest difference from turned sets over the largest") {
    const std::vector<Vec3> directions = sample_set(SampleSet::random, 40);
    const QuadratureRule rule = bayesian_rule(Sobolev(), 1e-4, directions);
    double difference = 0, largest = 0;
    for (const double turns : {0.1, 0.3, 0.6, 0.8}) {
        std::vector<Vec3> turned;
        for (auto each = directions.rbegin(); each != directions.rend(); ++each)
            turned.push_back(rotate_around_y(*each, turns));
        const std::vector<double> weights = bayesian_rule(Sobolev(), 1e-4, turned).weights;
        for (std::size_t i = 0; i < 40; ++i) {
            difference = std::max(difference, std::fabs(rule.weights[i] - weights[39 - i]));
            largest = std::max(largest, std::fabs(rule.weights[i]));
        }
    }
    const Stability found = stability_of(directions, Sobolev(), 1e-4).value();
    CHECK(found.weight_error == difference / largest);
    CHECK(found.constant == stability_constant(rule));
    CHECK(difference > 0);
    CHECK(found.weight_error < 1e-12);
}

TEST_CASE("what is singular is refused, and works with noise") {
    for (const SampleSet set : {SampleSet::duplicates, SampleSet::pole}) {
        CAPTURE(set);
        CHECK(!stability_of(sample_set(set, 100), Sobolev(), 0));
        CHECK(stability_of(sample_set(set, 100), Sobolev(), 1e-2)->weight_error < 1e-9);
    }
}

TEST_CASE("a nearly singular matrix leaves no digit") {
    const SquaredExponential smooth(1);
    CHECK(stability_of(sample_set(SampleSet::random, 100), smooth, 0)->weight_error >= 0.1);
}
