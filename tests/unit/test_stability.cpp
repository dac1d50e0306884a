#include "experiments/stability.h"
#include "test.h"

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
