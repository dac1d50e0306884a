// The errors of a picture in numbers that have the same distribution for all correct programs, and how far they are
// from those of correct pictures: in units of the spread over seeds, since pixels that share rules err alike.
#pragma once

#include "experiments/picture_error.h"

#include <string>
#include <vector>

namespace bmc {
// Each colour by itself: (*colour).x, y, z.
constexpr double Color::*channels[] = {&Color::x, &Color::y, &Color::z};

// RMSE, brightness and correlation as in ImageError; "alike", the fraction of neighbours whose errors differ by less
// than a tenth of the RMSE of all channels; "block", the largest error of the mean over a block of pixels; "near", the
// mean correlation of pixels up to two apart, some of which err alike where each has one of a few rules. Then the mean
// error of each colour on the sphere and on the rectangle, over its mean light; the roughness, a root mean square
// difference of the errors of neighbours; and for each lag, how much more the errors of pixels so far apart are
// correlated than those of neighbours. Lags with both signs of x, up to two, come first.
using Fingerprint = std::vector<double>;
constexpr std::size_t rmse_number = 0, brightness_number = 1, block_number = 4, first_part = 6,
                      roughness_number = first_part + 6, first_lag = roughness_number + 1;

Fingerprint fingerprint(const Image& picture, const Truth& truth);

// To a pixel that may have the same random numbers: a near one, or one a likely side of a tile away.
struct Lag {
    int x, y;
};
Lag lag_of(std::size_t number);

// The block of pixels with the largest error of the mean, of those from the left and the top of which at least half
// shows an object: the root mean square over the channels, and the block's centre.
struct BlockError {
    double error;
    int x, y;
};
BlockError largest_block_error(const Image& picture, const Truth& truth);

// Of number i on its scale, which for parts and lags is its own: the mean, and the deviation of a new number from it.
struct Spread {
    double mean, deviation;

    double deviations(double number) const { return (number - mean) / deviation; }
};
Spread spread_of(const std::vector<Fingerprint>& correct, std::size_t i);

// A number of a picture, the mean of correct pictures, and the range that is accepted.
struct Quantity {
    std::string name;
    double measured, expected, low, high;

    bool fits() const { return measured >= low && measured <= high; }
};

// Standard deviations that are accepted of a number; and of a lag, of which there are many.
struct Accepted {
    double deviations, of_lag;
};

// The first six numbers; "repeats", the lag that deviates most; and "together", how far the six are from those of
// correct pictures, in standard deviations of all at once.
struct Comparison {
    std::vector<Quantity> quantities;
    std::size_t most_deviating_lag;  // number

    const Quantity& operator[](const std::string& name) const;
    bool fits() const;
};
Comparison compare(const Fingerprint& measured, const std::vector<Fingerprint>& correct, Accepted accepted);
}  // namespace bmc
