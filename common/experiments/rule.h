// The numbers of a rule of Bayesian Monte Carlo, on directions that are drawn or read from a file.
#pragma once

#include "options.h"

#include <iosfwd>

namespace bmc {
// Directions, and the values measured there, if given.
struct Samples {
    std::vector<Vec3> directions;
    std::vector<double> values;  // one for each direction, or none
};

// Reads lines "x y z", "x y z value", or "x y z z_j weight" as rule prints them. Throws std::runtime_error that names
// the line for anything else, for a length that is not 1 within 1e-6, and for a direction below the horizon.
Samples read_samples(std::istream& in);

// Directions, z and weights; the weights' sum, whose truth is known; with values their integral, amplitude and standard
// error.
std::string rule_report(const GaussianProcess& process, Known known, const std::vector<double>& values = {});

struct Rule {
    std::size_t samples = 40;
    std::string directions;  // a file; empty: drawn
    bool matrices = false;
    ModelSettings settings;

    std::vector<Option> options();
    std::string report() const;
};
}  // namespace bmc
