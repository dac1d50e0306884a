// What accuracy costs: pictures of the sphere scene by several methods, their times, and their errors against a dense
// quadrature.
#pragma once

#include "base/statistics.h"
#include "command_line/command_line.h"
#include "light/environment.h"
#include "scene/render.h"

namespace bmc {
// The seconds of one call: the fewest of at least four calls, and of as many as take 8 ms.
double time_call(const std::function<void()>& action);

// What a report on pictures is asked for.
struct CostSettings {
    int size = 64;           // of the pictures, size x size pixels
    std::uint64_t seed = 1;  // picture i of seed k has the seed 1000 (k - 1) + i, i from 1; the truth has i = 0
    bool untimed = false;
    std::string environment = {};  // empty: the built-in lights
    std::vector<std::size_t> sample_counts{10, 40};
};
CostSettings taken_costs(Arguments& arguments);

// The error of an image, over the pixels that show an object.
struct ImageError {
    double rmse;         // of linear radiance, all channels
    double correlation;  // of the errors of horizontally neighbouring pixels, less their mean; 0 where there are none
    double brightness;   // mean error over mean of the truth
};
ImageError image_error(const Image& image, const Image& truth);

// A way to make pictures, and their errors over several seeds: if pixels share rules, there are as many independent
// errors as seeds, not as pixels.
struct PictureCost {
    RenderSettings settings;
    const char* method_column;
    std::function<Image(const RenderSettings&)> image;  // by such settings
    bool light_known = false;                           // beside what the density of the placement says
    RootMeanSquare rmse = {}, brightness = {};          // of each seed's ImageError
    Statistics correlation = {};
    double seconds_per_megapixel = 0;  // for a million pixels that show an object, on one processor; 0 unless timed
};

// A picture of the practice in this light, which must outlive it; and all that are compared, classic Monte Carlo first.
PictureCost compared_picture(const EnvironmentMap& light, Method method, std::size_t pool, Placement placement);
std::vector<PictureCost> compared_pictures(const EnvironmentMap& light);

// Those for which this light is known: mis and mis-ratio, as renderers sample such a light, and ours (known_light.h).
std::vector<PictureCost> known_light_pictures(const EnvironmentMap& light);

// The settings of a row: with these samples and the size. The row's pictures have the seeds that follow this one.
RenderSettings row_settings(const CostSettings& costs, RenderSettings settings, std::size_t samples);

// The same way with this number of samples, and its errors. Throws std::runtime_error if nothing is lit in the truth:
// then there is nothing to compare.
PictureCost measured_picture(PictureCost picture, std::size_t samples, const CostSettings& costs, const Image& truth);

// A line for each picture, and above them the names of the columns; the first pictures are classic Monte Carlo's.
std::string picture_table(const std::vector<PictureCost>& rows, bool timed);

// The picture_table of these pictures, each with all numbers of samples.
std::string measured_table(const CostSettings& costs, const std::vector<PictureCost>& compared, const Image& truth);

// The tables of the light, or of each of the built-in ones, each by its name.
using PictureTable = std::string (*)(const CostSettings& costs, const std::string& name, const EnvironmentMap& light);
std::string picture_report(const CostSettings& costs, PictureTable table);
}  // namespace bmc
