#include "experiments/reports.h"

#include "base/input.h"
#include "experiments/samples.h"
#include "quadrature/gaussian_process.h"
#include "quadrature/quadrature.h"

#include <algorithm>

namespace bmc {
static std::string matrix_block(const char* name, const Matrix& matrix) {
    std::string text = formatted("\n\n# %s, %zu x %zu\n", name, matrix.rows, matrix.columns);
    for (std::size_t i = 0; i < matrix.rows; ++i)
        for (std::size_t j = 0; j < matrix.columns; ++j)
            text += formatted("%16.9g", matrix(i, j)) + (j + 1 < matrix.columns ? " " : "\n");
    return text;
}

// About how many digits of the weights are right. A pivot u_mm^2 is what up to n subtractions leave of an element of Q.
// Each rounds up or down, so about sqrt(n) roundings add up, rarely four times as many; the least pivot loses most.
// (Directions in a lattice can lose more if the noise is 1e-4 or less.)
static int right_digits(const Cholesky& cholesky) {
    double least = cholesky.upper(0, 0);
    for (std::size_t m = 1; m < cholesky.size(); ++m) least = std::min(least, cholesky.upper(m, m));
    const double ratio = cholesky.upper(0, 0) / least, n = static_cast<double>(cholesky.size());
    const double error = 4 * DBL_EPSILON * std::sqrt(n) * ratio * ratio;
    if (error > 0.1)
        throw std::runtime_error("rounding leaves no digit of the weights right; take more noise, such as 0.1");
    return static_cast<int>(-portable::log(error) / portable::log(10));
}

static std::string weights_block(const GaussianProcess& process, int digits) {
    std::string text = formatted("#%23s %24s %24s %12s %24s\n", "x", "y", "z", "z_j", "weight");
    double sum = 0;
    int negative = 0;
    for (std::size_t i = 0; i < process.weights.size(); ++i) {
        const Vec3 omega = process.directions[i];
        const double weight = process.weights[i];
        text += formatted("%24.17g %24.17g %24.17g %12.9g %24.17g\n", omega.x, omega.y, omega.z, process.z[i], weight);
        sum += weight;
        negative += weight < 0;
    }
    const QuadratureRule rule{process.directions, process.weights, process.known};
    const double integral = known_integral(process.known);
    return text + formatted(
                      R"(# The weights sum to %.*g, and the integral of %s is %.6g. The ratio %#.*g would be 1 if the
# rule were exact for constants. Negative weights: %d.
# A white scene would render with the brightness B = %.*g instead of 1. The weights amplify the errors
# of samples %.*g times as much as Monte Carlo's do. Above 2, pictures are usually worse than Monte Carlo's.
# 17 digits give back the same doubles; ./workbench stability tells how many of a weight's digits are right.
)",
                      std::min(digits, 6), sum, process.known == Known::cosine ? "cos(theta)" : "1", integral,
                      std::min(digits, 4), sum / integral, negative, std::min(digits, 4), white_brightness(rule),
                      std::min(digits, 3), noise_gain(rule));
}

static std::string estimate_line(const GaussianProcess& process, const std::vector<double>& values, int digits) {
    const double estimate = process.integral(values), size = std::fabs(estimate);
    const double bar = process.error_bar(values), amplitude = process.amplitude(values);
    if (!std::isfinite(amplitude) || std::isinf(bar))
        throw std::runtime_error("the values are too large for their squares; divide all by one number");
    // Rounding changes the estimate by about 10^-digits of its error bar. An estimate that is smaller is printed as 0.
    int own = digits;
    for (double s = bar; s > size; s /= 10) --own;
    for (double s = 10 * bar; own < 9 && s <= size; s *= 10) ++own;
    std::string bar_text = formatted("%.*g", std::min(digits, 3), bar) +
                           "\n# It knows what the samples have seen; a lamp that none of them met is not in it.";
    if (std::isnan(bar)) bar_text = "unknown: what is left of the variance may be rounding; more noise makes it larger";
    if (amplitude == 0) bar_text = "unknown: the values are 0, or too small to be squared";
    return formatted("# The integral of the values%s: estimate %.*g, amplitude %.*g, error bar ",
                     process.known == Known::cosine ? " times cos(theta)" : "", std::min(own, 9),
                     own < 0 ? 0 : estimate, std::min(digits, 6), amplitude) +
           bar_text + '\n';
}

std::string rule_report(Arguments& arguments) {
    std::size_t samples = 40;
    std::string directions;  // a file; empty: drawn
    bool matrices = false;
    ModelSettings settings;
    arguments.add("samples", "N", "directions of the rule", samples, 1, max_process_samples);
    arguments.add("directions", "FILE", "read directions from FILE, a line x y z [value] each (-: standard input)",
                  directions);
    arguments.add("matrices", "also print Q and its inverse", matrices);
    add_model_options(arguments, settings);
    arguments.make_idle({"samples", "placement", "seed"}, "with --directions", [&] { return !directions.empty(); });
    arguments.take();
    if (!directions.empty()) settings.placement = {};  // directions in a file have a density that nobody knows
    const auto covariance = settings.make_covariance();
    Random random(settings.seed, 0);
    const Samples given = directions.empty() ? Samples{sampler_of(settings.placement, samples)(random)}
                                             : read_file(directions, read_samples);
    const GaussianProcess process(*covariance, settings.noise, given.directions);
    const int digits = right_digits(process.cholesky);
    std::string text = weights_block(process, digits);
    if (!directions.empty())
        text += R"(# The weights are right if nobody looked at f to choose the directions. If some were drawn
# towards the light, an estimate may be far too bright: let f be the visibility, and the light a known factor.
)";
    if (!given.values.empty()) text += estimate_line(process, given.values, digits);
    if (!matrices) return text;
    return text + matrix_block("Q", covariance_matrix(*covariance, settings.noise, given.directions)) +
           matrix_block("Q^-1", process.inverse_covariance());
}
}  // namespace bmc
