// What accuracy costs: for an integral, its errors against samples and the seconds of each stage of a rule; for a
// picture, its errors under each of the built-in lights.
#pragma once

#include "experiments/integrands.h"
#include "experiments/picture_cost.h"

namespace bmc {
struct IntegralCost {
    std::size_t samples;
    double mc_error;                          // root mean square, from the variance of the integrand
    double bmc_error, bmc_error_uncertainty;  // root mean square over fresh sets, and its standard error

    // Of each stage: directions, Q, its factor, z, the weights; then of an estimate, and of z by a sum over many random
    // directions. Empty unless timed.
    std::vector<double> seconds;

    double rule_seconds() const;

    // Samples with which Monte Carlo has the error of Bayesian Monte Carlo.
    double equivalent_mc_samples() const;

    // The number of integrals after which a rule, made once, has taken less time than Monte Carlo with equal error. An
    // estimate of Monte Carlo draws its directions afresh.
    double integrals_to_pay_off() const;
};

// Sobolev 3/2, noise 0.01, on the integrand.
std::vector<IntegralCost> integral_costs(const Integrand& integrand, std::uint64_t seed, bool timed);

// What `workbench tradeoff` prints.
struct TradeoffReport {
    std::string environment;  // empty: the built-in lights
    CostSettings costs;
    bool all = false;

    Options options();
    std::string report() const;
};
}  // namespace bmc
