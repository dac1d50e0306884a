#include "experiments/rule.h"

#include "light/input.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace bmc {
namespace {

// White space or commas separate the numbers of a line, whose squares have finite sums; '#' begins a comment.
std::vector<double> numbers_of(std::string line) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::replace(line.begin(), line.end(), '\0', '?');  // which would end an error's text
    std::istringstream words(line.substr(0, line.find('#')));
    std::vector<double> numbers;
    for (std::string word; words >> word;) numbers.push_back(parse_real(word, -1e100, 1e100));
    return numbers;
}

// Throws std::runtime_error where the numbers are none of a direction, with or without a value as the samples before.
void add_sample(Samples& samples, const std::vector<double>& numbers) {
    const std::size_t n = numbers.size(), before = samples.directions.size();
    if (n < 3 || n > 5 || (before > 0 && (n == 4) == samples.values.empty()))
        throw std::runtime_error(formatted("%zu numbers; every line should be x y z, or every line x y z value", n));
    const Vec3 direction{numbers[0], numbers[1], numbers[2]};
    if (!(std::fabs(length(direction) - 1) <= 1e-6))
        throw std::runtime_error(
            formatted("the direction has length %.9g; it should be 1 within 1e-6", length(direction)));
    if (direction.y < 0)
        throw std::runtime_error(formatted("the direction lies below the horizon: its y is %.9g", direction.y));
    if (before == max_process_samples)
        throw std::runtime_error(formatted("there are more than %zu directions", before));
    samples.directions.push_back(direction);
    if (n == 4) samples.values.push_back(numbers[3]);
}

std::string matrix_block(const char* name, const Matrix& matrix) {
    std::string text = formatted("\n\n# %s, %zu x %zu\n", name, matrix.rows(), matrix.columns());
    for (std::size_t i = 0; i < matrix.rows(); ++i)
        for (std::size_t j = 0; j < matrix.columns(); ++j)
            text += formatted("%16.9g", matrix(i, j)) + (j + 1 < matrix.columns() ? " " : "\n");
    return text;
}

}  // namespace

Samples read_samples(std::istream& in) {
    Samples samples;
    std::size_t line = 1;
    char text[4096];
    try {
        for (; in.getline(text, sizeof text); ++line) {
            const auto length = static_cast<std::size_t>(in.gcount()) - !in.eof();  // without the '\n'
            if (const auto numbers = numbers_of({text, length}); !numbers.empty()) add_sample(samples, numbers);
        }
        if (!in.eof()) throw std::runtime_error("it is longer than 4095 characters");
    } catch (const std::runtime_error& error) {
        throw std::runtime_error("line " + std::to_string(line) + ": " + error.what());
    }
    if (samples.directions.empty()) throw std::runtime_error("there are no numbers in it");
    return samples;
}

std::string rule_report(const GaussianProcess& process, Known known, const std::vector<double>& values) {
    std::string text = "#       x         y         z          z_j       weight\n";
    double sum = 0;
    std::size_t negative = 0;
    for (std::size_t i = 0; i < process.weights().size(); ++i) {
        const Vec3 direction = process.directions()[i];
        const double weight = process.weights()[i];
        text += formatted("%9.6f %9.6f %9.6f %12.9g %12.6g\n", direction.x, direction.y, direction.z, process.z()[i],
                          weight);
        sum += weight;
        negative += weight < 0;
    }
    const bool cosine = known != Known::nothing;
    text += formatted("# The weights sum to %.6g, the integral of %s is %.6g; %zu weights are negative.\n", sum,
                      cosine ? "cos(theta)" : "1", cosine ? portable::pi : 2 * portable::pi, negative);
    if (!values.empty())
        text += formatted("# The integral of the values%s: estimate %.9g, amplitude %.6g, standard error %s\n",
                          cosine ? " times cos(theta)" : "", process.integral(values), process.amplitude(values),
                          process.amplitude(values) > 0 ? formatted("%.6g", process.standard_error(values)).c_str()
                                                        : "unknown: zeros tell no amplitude");
    return text;
}

std::vector<Option> Rule::options() {
    const auto drawn = [this] { return directions.empty() ? "" : "--directions gives the directions"; };
    const ModelOptions model(settings);
    return join({{useless_while(drawn, count_option("samples", "N", "directions of the rule (default 40)", samples,
                                                    max_process_samples)),
                  name_option("directions", "FILE", "read them instead: lines x y z or x y z value (-: standard input)",
                              directions),
                  {"matrices", "", "print Q and its inverse, too", [this](const std::string&) { matrices = true; }}},
                 model.process,
                 {model.known, useless_while(drawn, model.placement), useless_while(drawn, model.seed)}});
}

std::string Rule::report() const {
    require_closed_form(settings);
    Samples given;
    if (directions.empty()) {
        Random random(settings.seed, 0);
        given.directions = place_directions(settings.placement, samples, random).directions;
    } else {
        read_input(directions, [&](std::istream& in) { given = read_samples(in); });
    }
    const std::unique_ptr<Covariance> covariance = settings.make_covariance();
    const GaussianProcess process(*covariance, settings.noise, given.directions, settings.known);
    const std::string text = rule_report(process, settings.known, given.values);
    if (!matrices) return text;
    return text + matrix_block("Q", symmetric(covariance_matrix(*covariance, settings.noise, given.directions))) +
           matrix_block("Q^-1", process.inverse_covariance());
}
}  // namespace bmc
