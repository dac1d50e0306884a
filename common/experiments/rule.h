// The numbers of a rule of Bayesian Monte Carlo, on directions that are drawn or read from a file.
#pragma once

#include "command_line/model_options.h"

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

// What `workbench rule` prints: directions, z and weights; what the weights sum to; with values the estimate of their
// integral.
struct RuleReport : Experiment {
    std::size_t samples = 40;
    std::string directions;  // a file; empty: drawn
    bool matrices = false;
    ModelSettings settings;

    void add_options(Options& options) override;
    std::string report() const override;
};
}  // namespace bmc
