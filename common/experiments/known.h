// What it is worth to know that the integrand has a factor cos(theta): Monte Carlo and Bayesian Monte Carlo, without
// and with it.
#pragma once

#include "numerics/portable_math.h"

#include "experiments/command.h"

struct Known {
    std::vector<Option> options() { return {}; }
    std::string report() const;
};
