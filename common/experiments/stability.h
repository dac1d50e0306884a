// Where the arithmetic of a Gaussian process breaks: how many digits of its weights are right at the extremes of the
// number of samples, the noise, the covariance and the sample set. Rotating all directions about the up axis must not
// change a weight (covariance.h), but it changes every rounding error. The digits that stay the same are right.
#pragma once

#include "command_line/command_line.h"
#include "quadrature/quadrature.h"

#include <optional>
#include <string>

namespace bmc {
enum class SampleSet { random, duplicates, equator, pole, cluster };
constexpr const char* sample_set_names[] = {"random", "duplicates", "equator", "pole", "cluster"};

// n directions: random and uniform; half as many, each of them twice; all on the horizon; all at the pole; all within
// 1e-8 of one direction.
std::vector<Vec3> sample_set(SampleSet set, std::size_t n);

struct Stability {
    double weight_error;  // the largest difference from the weights of four rotated sets, over the largest weight;
                          // infinite if a rotated matrix cannot be factored
    double constant;      // stability_constant
};

// nullopt if the covariance matrix cannot be factored.
std::optional<Stability> stability_of(const std::vector<Vec3>& directions, const Covariance& covariance, double noise);

// What `workbench stability` prints.
struct StabilityReport : Experiment {
    void add_options(Options&) override {}
    std::string report() const override;
};
}  // namespace bmc
