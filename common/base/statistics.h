// The mean of numbers and its standard error, by Welford's algorithm (Technometrics 1962, page 419).
#pragma once

#include "base/portable_math.h"

namespace bmc {
struct Statistics {
    double count = 0, mean = 0;
    double squares = 0;  // sum of the squared differences from the mean

    void add(double number) {
        count += 1;
        const double difference = number - mean;
        mean += difference / count;
        squares += difference * (number - mean);
    }

    // The standard error of the mean; nan for fewer than two numbers.
    double standard_error() const { return std::sqrt(squares / count) / std::sqrt(count - 1); }
};

// The root mean square of errors and its standard error.
struct RootMeanSquare {
    Statistics squares;

    void add(double error) { squares.add(error * error); }
    double value() const { return std::sqrt(squares.mean); }

    // Since d(x^2) = 2 x dx, this is the standard error of the mean square divided by 2 x.
    double standard_error() const { return value() > 0 ? squares.standard_error() / (2 * value()) : 0; }
};
}  // namespace bmc
