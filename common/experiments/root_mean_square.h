// The root mean square of errors, and how far it may be off.
#pragma once

#include "numerics/portable_math.h"

#include <algorithm>
#include <cmath>

struct RootMeanSquare {
    double count = 0, squares = 0, fourth_powers = 0;

    void add(double error) {
        count += 1;
        squares += error * error;
        fourth_powers += error * error * (error * error);
    }

    double value() const { return count > 0 ? std::sqrt(squares / count) : 0; }

    // The standard error of the mean square, over the derivative of the square.
    double standard_error() const {
        const double mean = squares / count;
        const double variance = std::max(0.0, fourth_powers / count - mean * mean) / (count - 1);
        return mean > 0 ? std::sqrt(variance) / (2 * value()) : 0;
    }
};
