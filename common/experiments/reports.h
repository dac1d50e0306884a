// The reports of the workbench, a command for each, and what accuracy costs: pictures of the sphere scene by every
// method, against a dense quadrature. (The report without a command is in error_table.h.)
#pragma once

#include "base/statistics.h"
#include "command_line/command_line.h"
#include "light/environment.h"
#include "scene/render.h"

#include <iosfwd>

namespace bmc {
// Directions, and the values that were measured there: none, or one for each.
struct Samples {
    std::vector<Vec3> directions;
    std::vector<double> values = {};
};

// Reads lines "x y z" or "x y z value", all of one kind; # begins a comment. Throws std::runtime_error that names the
// line for anything else, for a length that is not 1 within 1e-6, for a direction below the horizon, and for more than
// 4096 directions, 65535 lines or 4095 characters in a line; so a file without an end takes little memory. An error of
// reading is an exception, too.
Samples read_samples(std::istream& in);

// rule: the directions of a rule, drawn or from a file, z and the weights; what the weights sum to; with values the
// estimate of their integral.
std::string rule_report(Arguments& arguments);

// belief: what a Gaussian process believes of the light that arrives at a point of the rectangle. Four discs side by
// side, as PPM, show the light and the samples, the posterior mean, the posterior standard deviation, and the error of
// the mean. stderr has the estimate of the integral.
std::string belief_discs(Arguments& arguments);

// light: an environment as a PFM file, which other programs read.
inline std::string light_file(Arguments& arguments) {
    std::string environment = built_in_lights[0];
    arguments.add("environment", "FILE", environment_help(), environment);
    arguments.take("desert.pfm");
    const EnvironmentMap map = load_environment(environment);
    Image image(map.width, map.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = map.colour(static_cast<int>(i) + 1);
    return encode(image, Format::pfm);
}

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
using PictureTable = std::string(const CostSettings& costs, const std::string& name, const EnvironmentMap& light);
std::string picture_report(const CostSettings& costs, const PictureTable& table);

// tradeoff: what accuracy costs. The time of each step of a rule, and the errors and the time of a picture by every
// method.
std::string tradeoff_report(Arguments& arguments);

// known-light: what is gained by knowing the light, and by what else renderers do with a light that they know.
std::string known_light_report(Arguments& arguments);

// models: which covariance and which noise the scene requires. It compares their errors, which takes the truth, their
// evidence, which does not, and the errors that they predict.
std::string models_report(Arguments& arguments);

// Log evidence of the values up to a constant, with the amplitude that maximises it: -n/2 log a^2 - 1/2 log det Q
// (Rasmussen & Williams, "Gaussian Processes for Machine Learning", 2006, eq. 5.8). Processes with one known part can
// be compared by it.
double log_evidence(const GaussianProcess& process, const std::vector<double>& values);

// n directions: random and uniform; half as many, each of them twice; all on the horizon; all at the pole; all within
// 1e-8 of one direction.
enum class SampleSet { random, duplicates, equator, pole, cluster };
inline constexpr const char* sample_set_names[] = {"random", "duplicates", "equator", "pole", "cluster"};
std::vector<Vec3> sample_set(SampleSet set, std::size_t n);

// stability: where the arithmetic of a Gaussian process breaks. How many digits of its weights are right at the
// extremes of the number of samples, the noise, the covariance and the sample set. Neither another order of the
// directions nor their rotation about the up axis must change a weight (covariance.h), nor must three times the
// covariance and the squared noise, but they change every rounding error. The digits that stay the same are right: a
// test compares them with weights of 128 bits.
std::string stability_report(Arguments& arguments);
}  // namespace bmc
