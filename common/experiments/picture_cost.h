// What accuracy costs: pictures of the sphere scene by several methods, their times, and their errors against a picture
// that is nearly exact.
#pragma once

#include "base/statistics.h"
#include "scene/render.h"

namespace bmc {
// The seconds of one call: the fewest of at least four calls, and of as many as take 8 ms.
double time_call(const std::function<void()>& action);

// The error of an image, over the pixels that show an object.
struct ImageError {
    double rmse;         // of linear radiance, all channels
    double correlation;  // of the errors of horizontally neighbouring pixels, less their mean; 0 where there are none
    double bias;         // mean error over mean of the truth, which must not be 0
};
ImageError image_error(const Image& image, const Image& truth);

// A way to make pictures. method and known are what the table calls it, and what is known of the integrand.
struct PictureMethod {
    std::string method, known;
    RenderSettings settings;
    std::function<Shader(const RenderSettings&)> shader;
};

// A line of the table: errors over several seeds. If pixels share rules, there are as many independent errors as seeds,
// not as pixels.
struct PictureRow {
    std::string method, known;
    RenderSettings settings;
    RootMeanSquare rmse = {}, bias = {};  // of each seed's ImageError
    Statistics correlation = {};
    double seconds_per_megapixel = 0;  // for a million pixels that show an object, on one processor; 0 unless timed
};

// The row of this method: pictures with its settings, their seeds those that follow the one there, against the truth,
// which has their size.
PictureRow picture_row(const PictureMethod& method, const Image& truth, bool timed);

// The table of these rows. The first one of each number of samples is classic Monte Carlo's.
std::string picture_table(const std::vector<PictureRow>& rows, bool timed);
}  // namespace bmc
