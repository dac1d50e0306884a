// The practice's experiment: the mean absolute error of Monte Carlo and of Bayesian Monte Carlo against the number of
// samples.
#pragma once

#include "base/statistics.h"
#include "experiments/integrands.h"

namespace bmc {
struct ErrorSettings : ModelSettings {
    std::vector<std::size_t> sample_counts{10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
    std::size_t mc_estimates = 1000, bmc_estimates = 1000;  // the sheet has 100 and 10: too few for a ratio
};

// Absolute errors of both methods, and those that the process predicts: none if Q could not be factored.
struct ErrorRow {
    std::size_t samples;
    Statistics mc = {}, bmc = {}, predicted = {};

    // How many times larger the error of Monte Carlo is; nan if one of the two is 0.
    double gain() const { return mc.mean > 0 && bmc.mean > 0 ? mc.mean / bmc.mean : NAN; }

    // The number of random samples with which Monte Carlo has the error of Bayesian Monte Carlo: its error falls as
    // 1 / sqrt(n).
    double equivalent_mc_samples() const { return static_cast<double>(samples) * gain() * gain(); }
};

// A row for each integrand, at least one. Every estimate has a fresh set of directions. Estimate e has the same set for
// both methods, so that columns differ by the method and not by luck, and for all integrands, so that its rule is made
// once. A warning says why a Q could not be factored.
std::vector<ErrorRow> error_rows(const std::vector<Integrand>& integrands, std::size_t samples,
                                 const ErrorSettings& settings);

// A line for each row, and below three rows or more the powers of the number of samples that both errors follow, with
// their standard errors. MC's is about -1/2 for random directions. nan stands for what has no meaning, such as the
// equivalent random samples of a placement that is not random.
std::string error_report(const Integrand& integrand, const std::vector<ErrorRow>& rows, Placement placement);
}  // namespace bmc
