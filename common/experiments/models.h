// Which covariance and which noise the scene requires: by the error, which needs the truth, by the evidence, which does
// not, and by the error that a process predicts.
#pragma once

#include "command_line/command_line.h"
#include "experiments/integrands.h"
#include "light/load_environment.h"

namespace bmc {
// Log evidence of the values up to a constant, with the amplitude that maximises it: -n/2 log a^2 - 1/2 log det Q
// (Rasmussen & Williams, "Gaussian Processes for Machine Learning", 2006, eq. 5.8). Processes with one known part can
// be compared by it.
double log_evidence(const GaussianProcess& process, const std::vector<double>& values);

// What `workbench models` prints.
struct ModelsReport : Experiment {
    std::string environment = built_in_lights[0];
    std::size_t samples = 40;

    void add_options(Options& options) override;
    std::string report() const override;
};
}  // namespace bmc
