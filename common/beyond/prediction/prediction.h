// The error of a picture, without the truth. Two pictures A and B by other random numbers are two draws of one
// estimate, whatever its method. If it has the variance v, then A - B has 2 v. So
//     v ~ mean of (A - B)^2 / 2
// over pixels that have about one v: those of a window, or of the whole picture (Rousselle, Knaus & Zwicker, "Adaptive
// rendering with non-local means filtering", ACM Transactions on Graphics 31(6), 2012). An error that both pictures
// have does not show.
#pragma once

#include "beyond/known_light/picture.h"

namespace bmc::beyond {
// The settings of the second picture of a pair: they have the next seed.
PictureSettings with_next_seed(PictureSettings settings);

// The standard error of each colour of each pixel, of either picture, over a window around it, as far as that shows the
// same object; 0 where no object is. Windows grow with the picture, from 7 x 7 pixels to 15 x 15 from 490 rows on, so
// that large pictures of errors are smooth.
Image standard_errors(const Image& a, const Image& b);

// The root mean square over all colours of the pixels that show an object; 0 where none does.
double root_mean_square(const Image& errors);

// The predicted RMSE of a picture before it is rendered, by a pilot: at every k-th pixel of every k-th row, k a 64th of
// the width and of the height (at least 1). Where few of these pixels show an object, more pairs of pictures follow, up
// to sixteen. 0 if none does.
double pilot_rmse(const EnvironmentLight& light, PictureSettings settings);

struct ChosenSamples {
    std::size_t samples;
    double rmse;  // predicted
};

// The fewest samples, at least 2, whose predicted RMSE is at most the target. Pilots try 2, 4, 8, ...; between the last
// two the RMSE is interpolated as a power of the samples. A pilot makes four processes in place of a pool, or of one
// for each pixel: that does not change the expected error. Throws std::runtime_error if `most` samples, at least 4, do
// not suffice; it names their RMSE, and how many samples the power points to. Throws what the Gaussian processes throw.
ChosenSamples samples_for(double target, std::size_t most, const EnvironmentLight& light, PictureSettings settings);
}  // namespace bmc::beyond
