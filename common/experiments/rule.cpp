#include "experiments/rule.h"

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

static std::string weights_block(const GaussianProcess& process, Known known) {
    std::string text = "#       x         y         z          z_j       weight\n";
    std::size_t negative = 0;
    for (std::size_t i = 0; i < process.weights().size(); ++i) {
        const Vec3 w = process.directions()[i];
        const double weight = process.weights()[i];
        text += formatted("%9.6f %9.6f %9.6f %12.9g %12.6g\n", w.x, w.y, w.z, process.z()[i], weight);
        negative += weight < 0;
    }
    const QuadratureRule rule{process.directions(), process.weights(), known};
    return text +
           formatted(
               "# The weights sum to %.6g; the integral of %s is %.6g. The ratio is %.4g: 1 is exact for constants.\n"
               "# Their sizes sum to S = %.4g times that integral. Monte Carlo has 1; above 2, errors of samples\n"
               "# grow and pictures get worse than Monte Carlo's. %zu weights are negative.\n",
               relative_weight_sum(rule) * known_integral(known), known == Known::cosine ? "cos(theta)" : "1",
               known_integral(known), relative_weight_sum(rule), stability_constant(rule), negative);
}

static std::string estimate_line(const GaussianProcess& process, Known known, const std::vector<double>& values) {
    const double amplitude = process.amplitude(values);
    return formatted(
        "# The integral of the values%s: estimate %.9g, amplitude %.6g, standard error %s\n",
        known == Known::cosine ? " times cos(theta)" : "", process.integral(values), amplitude,
        amplitude > 0 ? formatted("%.6g", process.standard_error(values)).c_str() : "unknown, since all values are 0");
}

Samples read_samples(std::istream& in) {
    Samples samples;
    std::size_t number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        std::istringstream words(line.substr(0, line.find('#')));
        std::vector<double> columns;
        for (std::string word; words >> word;) {
            char* end = nullptr;
            const double column = std::strtod(word.c_str(), &end);
            columns.push_back(*end == '\0' ? column : NAN);
        }
        if (columns.empty()) continue;
        const std::size_t n = columns.size();
        const Vec3 w = n >= 3 && n <= 5 ? Vec3{columns[0], columns[1], columns[2]} : Vec3{};
        if (!(std::fabs(length(w) - 1) <= 1e-6 && w.y >= 0 && std::isfinite(columns.back())))
            throw std::runtime_error(
                formatted("line %zu: it should be x y z, x y z value, or x y z z_j weight", number) +
                ", with a direction (x, y, z) of length 1 and y >= 0");
        samples.directions.push_back(w);
        if (columns.size() == 4) samples.values.push_back(columns[3]);
    }
    if (!samples.values.empty() && samples.values.size() != samples.directions.size())
        throw std::runtime_error("there are values in some lines only: all lines have one, or none has");
    if (samples.directions.empty() || samples.directions.size() > max_process_samples)
        throw std::runtime_error(
            formatted("there are %zu directions, and 1 to 4096 are allowed", samples.directions.size()));
    return samples;
}

Options RuleReport::options() {
    return joined(
        {Options{integer_option("samples", "N", "directions of the rule (default 40)", samples, max_process_samples),
                 text_option("directions", "FILE", "lines x y z or x y z value in their place (-: standard input)",
                             directions),
                 {"matrices", "", "prints Q and its inverse, too", [this](const std::string&) { matrices = true; }}},
         model_options(settings)});
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
