// A rule of Bayesian Monte Carlo, number by number.
#pragma once

#include "numerics/portable_math.h"

#include "experiments/command.h"

// A rule: its directions and weights, for whoever wants to plot or to reuse them, and how well it integrates the one
// integrand that every rule should.
std::string rule_report(const QuadratureRule& rule);

// Directions and weights of one rule.
struct Rule {
    std::size_t samples = 40;
    ModelOptions model;

    std::vector<Option> options();
    std::string report() const;
};
