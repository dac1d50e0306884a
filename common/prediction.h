// How far off a picture is, without the truth: two pictures A and B by other random numbers are two draws of one
// estimate, whatever its method. If it has the variance v, A - B has 2 v. So
//     v ~ mean of (A - B)^2 / 2
// over pixels that have about one v: those of a window, or of the whole picture (Rousselle, Knaus & Zwicker, "Adaptive
// rendering with non-local means filtering", ACM Transactions on Graphics 31(6), 2012). An error that both pictures
// have does not show.
#pragma once

#include "picture.h"

namespace bmc {
// What a file shows of each point: the light that it reflects, or the standard error predicted for that light.
enum class Show { picture, error };
constexpr std::pair<const char*, Show> show_names[] = {{"picture", Show::picture}, {"error", Show::error}};

// What is asked of a picture's error.
struct Prediction {
    Show show = Show::picture;
    double rmse = 0;  // the predicted RMSE to reach; 0: the number of samples is given
};

// The settings of the second picture of a pair: they have the next seed.
PictureSettings second(PictureSettings settings);

// The standard error of each colour of each pixel, of either picture: over a window around it, as far as it shows the
// same object; 0 where no object is. Windows grow with the picture, from 7 x 7 pixels to 15 x 15 from 490 rows on: so
// large pictures of errors are smooth.
Image standard_errors(const Scene& scene, const Image& a, const Image& b);

// The root mean square over all colours of the pixels that show an object; 0 where none does.
double root_mean_square(const Scene& scene, const Image& errors);

// The predicted RMSE of a picture before it is rendered, by a pilot: at every k-th pixel of every k-th row, k a 64th of
// the width and of the height (at least 1). Where few of these pixels show an object, more pairs of pictures follow, up
// to sixteen. 0 if none does.
double pilot_rmse(const Scene& scene, const EnvironmentLight& light, PictureSettings settings);

struct ChosenSamples {
    std::size_t samples;
    double rmse;  // predicted
};

// The fewest samples whose predicted RMSE is at most the target, but at least 2, or 8 where pixels share: all pixels
// have the error of too small a lattice, and no two pictures show it. Pilots try 2, 4, 8, ...; between the last two the
// RMSE is interpolated as a power of the samples. A pilot makes four processes in place of a pool or of one for each
// pixel: that does not change the expected error. Throws std::runtime_error, which tells the RMSE of the most samples,
// at least 4, if they do not suffice; and what the Gaussian processes throw.
ChosenSamples samples_for(double target, std::size_t most, const Scene& scene, const EnvironmentLight& light,
                          PictureSettings settings);

// The picture of the sphere scene under the environment, for a file of this format. stderr tells the prediction that is
// asked for. In a PPM errors are grey, and twice their root mean square is white. Throws what picture and samples_for
// throw. Throws UsageError for an RMSE under a sun (sun.h) that is not known: both pictures may miss it.
Image asked_picture(const EnvironmentMap& environment, PictureSettings settings, const Prediction& prediction,
                    Format format);
}  // namespace bmc
