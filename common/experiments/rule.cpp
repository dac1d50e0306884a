#include "experiments/rule.h"

#include "scene/input.h"

#include <cmath>

namespace bmc {
namespace {

void add_sample(Samples& samples, const InputRow& row, std::size_t columns) {
    const std::vector<double>& numbers = row.numbers;
    if (numbers.size() != columns || columns < 3 || columns > 5)
        fail(row.line, formatted("%zu numbers; every line should be x y z, or every line x y z value", numbers.size()));
    const Vec3 direction{numbers[0], numbers[1], numbers[2]};
    if (!(std::fabs(length(direction) - 1) <= 1e-6))
        fail(row.line, formatted("the direction has length %.9g; it should be 1 within 1e-6", length(direction)));
    if (direction.y < 0) fail(row.line, formatted("the direction lies below the horizon: its y is %.9g", direction.y));
    samples.directions.push_back(direction);
    if (columns == 4) samples.values.push_back(numbers[3]);
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
    const std::vector<InputRow> rows = read_rows(in, max_process_samples);
    for (const InputRow& row : rows) add_sample(samples, row, rows[0].numbers.size());
    return samples;
}

std::string rule_report(const GaussianProcess& process, KnownPart known, const std::vector<double>& values) {
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
    const bool cosine = known == KnownPart::cosine;
    text += formatted("# The weights sum to %.6g, the integral of %s is %.6g; %zu weights are negative.\n", sum,
                      cosine ? "cos(theta)" : "1", cosine ? portable::pi : 2 * portable::pi, negative);
    if (!values.empty())
        text += formatted("# The integral of the values%s: estimate %.9g, amplitude %.6g, standard error %.6g\n",
                          cosine ? " times cos(theta)" : "", process.integral(values), process.amplitude(values),
                          process.standard_error(values));
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
                 {useless_while(drawn, model.placement), useless_while(drawn, model.seed)}});
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
