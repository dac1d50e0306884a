// What accuracy costs: for an integral, its errors against samples and the seconds of each stage of a rule; for a
// picture, its errors under each of the built-in lights.
#pragma once

#include "experiments/integrands.h"
#include "experiments/picture_cost.h"

#include <numeric>

namespace bmc {
struct IntegralCost {
    std::size_t samples;
    double mc_error;                          // root mean square, from the variance of the integrand
    double bmc_error, bmc_error_uncertainty;  // root mean square over fresh sets, and its standard error

    // Of each stage: directions, Q, its factor, z, the weights; then of an estimate. Empty unless timed.
    std::vector<double> seconds;

    double rule_seconds() const { return std::accumulate(seconds.begin(), seconds.end() - 1, 0.0); }

    // Samples with which Monte Carlo would have the error of Bayesian Monte Carlo.
    double equivalent_mc_samples() const {
        return static_cast<double>(samples) * (mc_error / bmc_error) * (mc_error / bmc_error);
    }

    // The number of integrals after which a rule, made once, has taken less time than Monte Carlo with equal error. An
    // estimate of Monte Carlo draws its directions afresh.
    double integrals_to_pay_off() const {
        const double mc_sample = (seconds.front() + seconds.back()) / static_cast<double>(samples);
        return rule_seconds() / (equivalent_mc_samples() * mc_sample - seconds.back());
    }
};

// Sobolev 3/2, noise 0.01, on the integrand.
std::vector<IntegralCost> integral_costs(const Integrand& integrand, std::uint64_t seed, bool timed);

struct Tradeoff {
    std::string environment;  // empty: the built-in lights
    CostSettings costs;
    bool all = false;

    std::vector<Option> options();
    std::string report() const;
};
}  // namespace bmc
