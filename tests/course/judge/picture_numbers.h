// What a picture differs from the truth by, in numbers that correct pictures have alike whatever their random numbers
// are, and how far such numbers may be from theirs: a spread over seeds, since pixels that share rules err alike.
#pragma once

#include "experiments/picture_error.h"

#include <string>
#include <vector>

// RMSE, brightness and correlation as image_error has them; "alike", the fraction of neighbours whose errors differ by
// less than a tenth of the RMSE of all channels; "block", the largest error of the mean over a block of pixels; then
// for each of the lags, how much more the errors of pixels so far apart are correlated than those of neighbours.
using Numbers = std::vector<double>;
constexpr std::size_t named_numbers = 5;

// To a pixel that may have the same random numbers: a near one, or one a likely side of a tile away.
struct Lag {
    int x, y;
};
Lag lag_of(std::size_t number);

// The block of pixels whose mean differs most from the truth's, of those from the left and the top of which at least
// half shows an object: the root mean square over the channels, and the block's centre.
struct BlockError {
    double error;
    int x, y;
};
BlockError largest_block_error(const Image& picture, const Truth& truth);

Numbers numbers_of(const Image& picture, const Truth& truth);

// A number of a picture, the mean and the standard deviation of correct pictures', and the range that is accepted.
struct Quantity {
    std::string name;
    double here, expected, spread, low, high;

    bool fits() const { return here >= low && here <= high; }
};

// Standard deviations that a number may be away from the mean; of a lag, of which there are many, more.
struct Accepted {
    double deviations, of_lag;
};

// The named numbers beside those of correct pictures; "repeats", that of the lag that is strangest; and "together", how
// far the named ones are from those of correct pictures, in standard deviations of all at once.
struct Comparison {
    std::vector<Quantity> quantities;
    std::size_t strangest;  // number

    const Quantity& operator[](const std::string& name) const;
    bool fits() const;
};
Comparison compared(const Numbers& here, const std::vector<Numbers>& correct, Accepted accepted);
