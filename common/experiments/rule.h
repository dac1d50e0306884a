// A rule of Bayesian Monte Carlo, number by number, on directions that are drawn or that another program wrote.
#pragma once

#include "options.h"

#include <iosfwd>

namespace bmc {
// Directions, and what was measured in them if they come with values.
struct Samples {
    std::vector<Vec3> directions;
    std::vector<double> values;  // one for each direction, or none
};

// Reads "x y z", "x y z value" or "x y z z_j weight", as rule prints it, a line. Throws std::runtime_error that names
// the line for anything else, a length that is not 1 within 1e-6, and a direction below the horizon.
Samples read_samples(std::istream& in);

// Directions, z and weights; how well the weights integrate the one integrand that every rule should; with values their
// integral, amplitude and standard error.
std::string rule_report(const GaussianProcess& process, KnownPart known, const std::vector<double>& values = {});

struct Rule {
    std::size_t samples = 40;
    std::string directions;  // a file; empty: drawn
    bool matrices = false;
    ModelSettings settings;

    std::vector<Option> options();
    std::string report() const;
};
}  // namespace bmc
