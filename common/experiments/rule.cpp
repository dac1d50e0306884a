#include "experiments/rule.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

namespace bmc {
static std::string matrix_block(const char* name, const Matrix& matrix) {
    std::string text = formatted("\n\n# %s, %zu x %zu\n", name, matrix.rows(), matrix.columns());
    for (std::size_t i = 0; i < matrix.rows(); ++i)
        for (std::size_t j = 0; j < matrix.columns(); ++j)
            text += formatted("%16.9g", matrix(i, j)) + (j + 1 < matrix.columns() ? " " : "\n");
    return text;
}

// 17 digits are a double: read_samples reads the directions that are printed here.
static std::string weights_block(const GaussianProcess& process, Known known) {
    std::string text =
        R"(#                      x                        y                        z          z_j                   weight
)";
    std::size_t negative = 0;
    for (std::size_t i = 0; i < process.weights().size(); ++i) {
        const Vec3 w = process.directions()[i];
        const double weight = process.weights()[i];
        text += formatted("%24.17g %24.17g %24.17g %12.9g %24.17g\n", w.x, w.y, w.z, process.z()[i], weight);
        negative += weight < 0;
    }
    const QuadratureRule rule{process.directions(), process.weights(), known};
    const double ratio = relative_weight_sum(rule), integral = known_integral(known);
    return text +
           formatted(
               R"(# The weights sum to %.6g, and the integral of %s is %.6g. The ratio %.4g would be 1 if the rule were exact
# for constants. S = sum of |w_j| over that integral = %.4g (Monte Carlo: 1). %s negative.
# A white scene would render with the brightness B = %.4g instead of 1. The weights amplify the errors of samples
# %.3g times as much as Monte Carlo's weights do. Above 2, pictures are usually worse than Monte Carlo's.
)",
               ratio * integral, known == Known::cosine ? "cos(theta)" : "1", integral, ratio, stability_constant(rule),
               negative == 0   ? "No weight is"
               : negative == 1 ? "1 weight is"
                               : formatted("%zu weights are", negative).c_str(),
               white_brightness(rule), noise_gain(rule));
}

static std::string estimate_line(const GaussianProcess& process, Known known, const std::vector<double>& values) {
    const double estimate = process.integral(values), error = process.standard_error(values);
    if (!std::isfinite(estimate + process.amplitude(values)))
        throw std::runtime_error("the estimate exceeds the largest number, 1.8e308; scale the values down");
    std::string bar = formatted("%.6g", error);
    if (std::isnan(error)) bar = "unknown: what is left of the variance is rounding; more noise makes it larger";
    if (process.amplitude(values) == 0) bar = "unknown: the values are 0, or too small to be squared";
    return formatted("# The integral of the values%s: estimate %.9g, amplitude %.6g, standard error ",
                     known == Known::cosine ? " times cos(theta)" : "", estimate, process.amplitude(values)) +
           bar + '\n';
}

// What is no number counts as NAN.
static std::vector<double> columns_of(const std::string& line) {
    std::istringstream words(line.substr(0, line.find('#')));
    words.exceptions(std::ios::badbit);  // a lack of memory does not end the line
    std::vector<double> columns;
    for (std::string word; words >> word;) {
        char* end = nullptr;
        const double column = std::strtod(word.c_str(), &end);
        columns.push_back(end == word.c_str() + word.size() ? column : NAN);
    }
    return columns;
}

Samples read_samples(std::istream& in) {
    in.exceptions(std::ios::badbit);  // an error of reading does not end the file
    Samples samples;
    char line[4096];
    std::size_t number = 1;
    for (; in.getline(line, sizeof line) && number < 65536; ++number) {
        const std::vector<double> columns =
            columns_of(std::string(line, static_cast<std::size_t>(in.gcount()) - !in.eof()));
        if (columns.empty()) continue;
        const std::size_t n = columns.size();
        const Vec3 w = n >= 3 && n <= 5 ? Vec3{columns[0], columns[1], columns[2]} : Vec3{};
        if (!(std::fabs(length(w) - 1) <= 1e-6 && w.y >= 0 && std::isfinite(columns.back())))
            throw std::runtime_error(
                formatted("line %zu: it should be x y z, x y z value, or x y z z_j weight", number) +
                ", with a direction (x, y, z) of length 1 and y >= 0");
        samples.directions.push_back(w);
        if (n == 4) samples.values.push_back(columns[3]);
        if (samples.directions.size() > max_process_samples)
            throw std::runtime_error(formatted("line %zu: at most 4096 directions are allowed", number));
    }
    if (!in.fail() || !in.eof())  // a line too many, or a longer one
        throw std::runtime_error(formatted("line %zu: fewer than 65536 lines of fewer than 4096 characters", number) +
                                 " are allowed");
    if (!samples.values.empty() && samples.values.size() != samples.directions.size())
        throw std::runtime_error("there are values in some lines only: all lines have one, or none has");
    if (samples.directions.empty()) throw std::runtime_error("there is no direction in the file");
    return samples;
}

void RuleReport::add_options(Options& options) {
    options.add("samples", "N", "directions of the rule (default 40)", samples, 1, max_process_samples);
    options.add("directions", "FILE", "read directions from FILE, a line x y z [value] each (-: standard input)",
                directions);
    options.add("matrices", "print Q and its inverse, too", matrices);
    add_model_options(options, settings);
    if (!directions.empty()) options.make_idle({"samples", "placement", "seed"}, "--directions");
}

std::string RuleReport::report() const {
    Samples given;
    if (directions.empty()) {
        Random random(settings.seed, 0);
        given.directions = place_directions(settings.placement, samples, random).directions;
    } else {
        std::ifstream file(directions);
        if (directions != "-" && !file) throw std::runtime_error(directions + ": this file cannot be read");
        given = read_samples(directions == "-" ? std::cin : file);
        if (std::ferror(stdin)) throw std::runtime_error("standard input cannot be read to its end");
    }
    const auto covariance = settings.make_covariance();
    const GaussianProcess process(*covariance, settings.noise, given.directions);
    std::string text = weights_block(process, settings.known);
    if (!given.values.empty()) text += estimate_line(process, settings.known, given.values);
    if (!matrices) return text;
    return text + matrix_block("Q", covariance_matrix(*covariance, settings.noise, given.directions)) +
           matrix_block("Q^-1", process.inverse_covariance());
}
}  // namespace bmc
