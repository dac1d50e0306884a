// What accuracy costs: of an integral, and of a picture under each of the built-in lights.
#pragma once

#include "experiments/picture_cost.h"

struct Tradeoff {
    std::string environment;  // empty: the built-in lights
    CostSettings costs;
    bool all = false;

    std::vector<Option> options();
    std::string report() const;
};
