// The reports of the workbench, a command for each. (That without a command is in error_table.h.)
#pragma once

#include "experiments/picture_cost.h"
#include "quadrature/gaussian_process.h"

#include <iosfwd>

namespace bmc {
// Directions, and the values that were measured there: none, or one for each.
struct Samples {
    std::vector<Vec3> directions;
    std::vector<double> values = {};
};

// Reads lines "x y z" or "x y z value", all of one kind; # begins a comment. Throws std::runtime_error that names the
// line for anything else, for a length that is not 1 within 1e-6, for a direction below the horizon, and for more than
// 4096 directions, 65535 lines or 4095 characters in a line; so a file without an end takes little memory. An error of
// reading is an exception, too.
Samples read_samples(std::istream& in);

// rule: the directions of a rule, drawn or from a file, z and the weights; what the weights sum to; with values the
// estimate of their integral.
struct RuleReport : Experiment {
    std::size_t samples = 40;
    std::string directions;  // a file; empty: drawn
    bool matrices = false;
    ModelSettings settings;

    void add_options(Options& options) override;
    std::string report() const override;
};

// belief: what a Gaussian process believes of the light that arrives at a point of the rectangle. Four discs side by
// side, as PPM, show the light and the samples, the posterior mean, the posterior standard deviation, and the error of
// the mean. stderr has the estimate of the integral.
struct Belief : Experiment {
    std::size_t samples = 40;
    std::string environment = built_in_lights[0];
    ModelSettings settings;

    void add_options(Options& options) override;
    std::string report() const override;
};

// light: an environment as a PFM file, which other programs read.
struct LightFile : Experiment {
    std::string environment = built_in_lights[0];

    void add_options(Options& options) override { options.add("environment", "FILE", environment_help(), environment); }
    std::string report() const override;
};

// tradeoff: what accuracy costs. The time of each step of a rule, and the errors and the time of a picture by every
// method.
struct TradeoffReport : PictureReport {
    std::string report() const override;
    std::string table(const std::string& name, const EnvironmentMap& light) const override;
};

// models: which covariance and which noise the scene requires. By the error, which needs the truth, by the evidence,
// which does not, and by the error that a process predicts.
struct ModelsReport : Experiment {
    std::string environment = built_in_lights[0];
    std::size_t samples = 40;

    void add_options(Options& options) override;
    std::string report() const override;
};

// Log evidence of the values up to a constant, with the amplitude that maximises it: -n/2 log a^2 - 1/2 log det Q
// (Rasmussen & Williams, "Gaussian Processes for Machine Learning", 2006, eq. 5.8). Processes with one known part can
// be compared by it.
double log_evidence(const GaussianProcess& process, const std::vector<double>& values);

// stability: where the arithmetic of a Gaussian process breaks. How many digits of its weights are right at the
// extremes of the number of samples, the noise, the covariance and the sample set. Rotating all directions about the up
// axis must not change a weight (covariance.h), nor must three times the covariance and the squared noise, but they
// change every rounding error. The digits that stay the same are right.
struct StabilityReport : Experiment {
    std::string report() const override;
};
}  // namespace bmc
