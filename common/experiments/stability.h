// Where the arithmetic of a Gaussian process breaks: how many digits of its weights are right at the extremes of the
// number of samples, the noise, the covariance and the sample set. Turning all directions about the up axis must not
// change a weight (covariance.h), but it changes every rounding error. The digits that stay the same are right.
#pragma once

#include "command_line.h"
#include "experiments/models.h"

#include <string>
#include <vector>

namespace bmc {
enum class SampleSet { random, duplicates, equator, pole, cluster };
constexpr std::pair<const char*, SampleSet> sample_set_names[] = {{"random", SampleSet::random},
                                                                  {"duplicates", SampleSet::duplicates},
                                                                  {"equator", SampleSet::equator},
                                                                  {"pole", SampleSet::pole},
                                                                  {"cluster", SampleSet::cluster}};

// n directions: random and uniform; half as many, each of them twice; all on the rim; all at the pole; all within 1e-8
// of one direction.
std::vector<Vec3> sample_set(SampleSet set, std::size_t n);

struct StabilityRow {
    SampleSet set;
    std::size_t samples;
    Model model;
    double noise;
    bool refused = false;  // the covariance matrix; then the numbers below are 0

    // The largest difference from the weights of four turned sets, over the largest weight; infinite if one is refused.
    double weight_error = 0;

    // For up to 1000 samples, since the inverse of more takes long: |Q| |Q^-1| by row_sum_norm, and the same difference
    // for the weights Q^-1 z.
    double condition = 0, inverse_error = 0;
};

StabilityRow examine_stability(SampleSet set, std::size_t n, const Model& model, double noise);

struct Stability {
    bool all = false;

    std::vector<Option> options();
    std::string report() const;
};
}  // namespace bmc
