// The practice's experiment: the mean absolute error of Monte Carlo and of Bayesian Monte Carlo against the number of
// samples.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "experiments/integrands.h"
#include "options.h"

namespace bmc {
struct ErrorSettings : ModelSettings {
    std::vector<std::size_t> samples{10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
    std::size_t mc_estimates = 100, bmc_estimates = 10;
};

// Mean absolute errors of Monte Carlo and of Bayesian Monte Carlo, and the mean standard error that the latter
// predicts. Errors below 1e-12 of the truth are rounding and count as 0, so that programs that multiply in another
// order agree.
struct ErrorRow {
    std::size_t samples;
    double mc_error, bmc_error, bmc_predicted;

    // How many times smaller the error of Bayesian Monte Carlo is.
    double gain() const {
        if (bmc_error > 0) return mc_error / bmc_error;
        return mc_error > 0 ? HUGE_VAL : 1;
    }

    // Samples with which Monte Carlo would have that error: its error falls as 1 / sqrt(n).
    double equivalent_mc_samples() const { return static_cast<double>(samples) * gain() * gain(); }
};

// Every estimate has a fresh set of directions. Estimate e uses the same set in every column, so that columns differ by
// the method and not by luck.
std::vector<ErrorRow> error_table(const Integrand& integrand, const ErrorSettings& settings);

std::string error_report(const Integrand& integrand, const std::vector<ErrorRow>& rows);

// The practice's integrand of that name, or all of them if it is empty. Throws UsageError if there is none.
std::vector<Integrand> integrands_named(const std::string& name);

// What the workbench prints without a command: the tables of the practice's integrands.
struct ErrorTables {
    std::string integrand;  // empty: all
    ErrorSettings settings;

    std::vector<Option> options();
    std::string report() const;
};
}  // namespace bmc
