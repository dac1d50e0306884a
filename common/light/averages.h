// Means of an environment over all directions.
#pragma once

#include "light/environment.h"

#include <algorithm>

namespace bmc {
// R + G + B, where one number stands for a radiance.
inline double brightness(Colour c) { return c.x + c.y + c.z; }

// The mean over all directions of f(L). Only u = 1 or v = 1 meets the last column or row (environment.h), so these have
// no area and are left out; a map of one row or column keeps it.
template <class Function>
double mean_over_directions(const EnvironmentMap& map, Function f) {
    const int columns = std::max(1, map.width - 1), rows = std::max(1, map.height - 1);
    const auto cosine = [&](int y) { return portable::sincos_turns(0.5 * y / rows).cosine; };
    double sum = 0;
    for (int y = 0; y < rows; ++y) {
        double row_sum = 0;
        for (int x = 0; x < columns; ++x) row_sum += f(map.colour(map.index(x, y)));
        sum += 2 * portable::pi / columns * (cosine(y) - cosine(y + 1)) * row_sum;
    }
    return sum / (4 * portable::pi);
}

// The mean over all directions of (b - mean)^power, where b is brightness(L) and has this mean.
inline double central_moment(const EnvironmentMap& map, double mean, int power) {
    return mean_over_directions(map, [=](Colour c) {
        double product = 1;
        for (int i = 0; i < power; ++i) product *= brightness(c) - mean;
        return product;
    });
}

// c, the standard deviation of the light over its mean; nan for a black one. N independent samples err by about
// c / sqrt(N) of what they estimate, so where c > sqrt(N) they miss the light.
inline double contrast(const EnvironmentMap& map) {
    const double mean = mean_over_directions(map, brightness);
    return std::sqrt(central_moment(map, mean, 2)) / mean;
}
}  // namespace bmc
