// The practice's experiment: the mean absolute error of Monte Carlo and of Bayesian Monte Carlo against the number of
// samples.
#pragma once

#include <string>
#include <vector>

#include "experiments/integrands.h"
#include "options.h"

struct ErrorSettings : ModelSettings {
    std::vector<std::size_t> samples{10, 20, 30, 40, 50, 60, 70, 80, 90, 100};
    std::size_t mc_estimates = 100, bmc_estimates = 10;
};

// Mean absolute errors of Monte Carlo, of Bayesian Monte Carlo and of that with the squared-exponential covariance as a
// rival, and the mean standard error that the first predicts. What is less than 1e-12 of the truth is rounding and
// counts as 0, so that a program that multiplies in another order has the same row.
struct ErrorRow {
    std::size_t samples;
    double mc_error, bmc_error, bmc_predicted, rival_error;
    std::string refusal = "";  // why the rival's covariance matrix was refused; rival_error is not set then

    // How many times smaller the error of Bayesian Monte Carlo is.
    double gain() const;

    // Samples with which Monte Carlo would have that error: its error falls as 1 / sqrt(n).
    double equivalent_mc_samples() const { return static_cast<double>(samples) * gain() * gain(); }
};

// Every estimate has a fresh set of directions; estimate e uses the same set in every column, so that the columns
// differ by method and not by luck.
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
