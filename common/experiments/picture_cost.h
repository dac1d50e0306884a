// What the accuracy of a picture costs: the sphere scene by every method against a dense quadrature.
#pragma once

#include "command_line/command_line.h"
#include "scene/render.h"

namespace bmc {
struct CostSettings {
    int size = 64;           // of the pictures, size x size pixels
    std::uint64_t seed = 1;  // picture i of seed k has the seed 1000 (k - 1) + i, i from 1
    bool timed = true;
};

// size, seed, no-times.
Options cost_options(CostSettings& costs);

// A way to make pictures: settings, except for the number of samples; what is known of the integrand, as a word; and
// the image by such settings.
struct ComparedPicture {
    RenderSettings settings;
    const char* known;
    std::function<Image(const RenderSettings&)> image;
};

// Errors over several seeds: if pixels share rules, there are as many independent errors as seeds, not as pixels.
struct PictureCost {
    RenderSettings settings;
    const char* known;
    double rmse;                   // of linear radiance, over the pixels that show an object, all channels and seeds
    double rmse_error;             // standard error of rmse
    double correlation;            // of the errors of horizontally neighbouring pixels, mean over the seeds
    double brightness;             // root mean square over the seeds of ImageError::brightness
    double seconds_per_megapixel;  // for a million pixels that show an object, on one processor; 0 unless timed
};

// The settings of a row: with these samples, the size and the first seed. The row has the seeds from there on.
RenderSettings row_settings(const CostSettings& costs, RenderSettings settings, std::size_t samples);
std::uint64_t seeds_of(const RenderSettings& settings);

// What is compared in this light, which must outlive it, classic Monte Carlo first.
ComparedPicture compared_picture(const EnvironmentMap& light, Method method, std::size_t pool, Placement placement,
                                 Known known = Known::nothing);
std::vector<ComparedPicture> compared_pictures(const EnvironmentMap& light);

// The seconds of one call: the least of four measurements, which take at least 2 ms each.
double time_call(const std::function<void()>& action);

// The parts of a Progress that picture_costs makes up, if a reference image is one.
constexpr double table_parts = 9;

// Each of the pictures with each number of samples. Throws std::runtime_error if nothing is lit in the truth: then
// there is nothing to compare.
std::vector<PictureCost> picture_costs(const std::vector<ComparedPicture>& compared,
                                       const std::vector<std::size_t>& samples, const CostSettings& costs,
                                       const Image& truth);

// A line for each picture; the first pictures are classic Monte Carlo's. more: further cells of each line.
std::string picture_table(const std::vector<PictureCost>& rows, bool timed, const char* more_heading = "",
                          const std::vector<std::string>& more = {});
}  // namespace bmc
