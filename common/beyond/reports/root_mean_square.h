// The root mean square of errors and its standard error.
#pragma once

#include "experiments/statistics.h"

namespace bmc {
struct RootMeanSquare {
    Statistics squares;

    void add(double error) { squares.add(error * error); }
    double value() const { return std::sqrt(squares.mean); }

    // The standard error of the mean square, over the derivative of the square.
    double standard_error() const { return value() > 0 ? squares.standard_error() / (2 * value()) : 0; }
};
}  // namespace bmc
