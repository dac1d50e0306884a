// The mean of numbers and how far they scatter, and the root mean square of errors.
#pragma once

#include "numerics/portable_math.h"

#include <cmath>

namespace bmc {
// Welford, "Note on a method for calculating corrected sums of squares and products", Technometrics 1962.
struct Statistics {
    double count = 0, mean = 0;
    double squares = 0;  // sum of the squared differences from the mean

    void add(double number) {
        count += 1;
        const double difference = number - mean;
        mean += difference / count;
        squares += difference * (number - mean);
    }

    // Of the mean.
    double standard_error() const { return std::sqrt(squares / count) / std::sqrt(count - 1); }
};

struct RootMeanSquare {
    Statistics squares;

    void add(double error) { squares.add(error * error); }
    double value() const { return std::sqrt(squares.mean); }

    // That of the mean square, over the derivative of the square.
    double standard_error() const { return value() > 0 ? squares.standard_error() / (2 * value()) : 0; }
};
}  // namespace bmc
