#include "experiments/reports.h"

#include "base/input.h"
#include "experiments/samples.h"
#include "quadrature/gaussian_process.h"
#include "quadrature/quadrature.h"

#include <numeric>

namespace bmc {
static std::string matrix_block(const char* name, const Matrix& matrix) {
    std::string text = formatted("\n\n# %s, %zu x %zu\n", name, matrix.rows, matrix.columns);
    for (std::size_t i = 0; i < matrix.rows; ++i)
        for (std::size_t j = 0; j < matrix.columns; ++j)
            text += formatted("%16.9g", matrix(i, j)) + (j + 1 < matrix.columns ? " " : "\n");
    return text;
}

// About how far off rounding leaves a^T Q^-1 b, from A = Q^-1 a and B = Q^-1 b. What is rounded in Q and in its factor
// acts like a matrix D that is added to Q: it changes this number by -A^T D B. The elements of D are about sqrt(n)
// roundings of the largest element of Q, with random signs; four times that is rarely exceeded.
static double rounding(const GaussianProcess& process, const std::vector<double>& A, const std::vector<double>& B) {
    const auto squares = [](const auto& v) { return std::inner_product(v.begin(), v.end(), v.begin(), 0.0); };
    const double root = process.cholesky.upper(0, 0), n = static_cast<double>(A.size());
    return 4 * DBL_EPSILON * std::sqrt(n) * root * root * std::sqrt(squares(A)) * std::sqrt(squares(B));
}

// A number in those of its digits that are right, at most so many.
static std::string right_digits(double number, double error, int most) {
    int digits = 0;
    for (double scaled = 10 * error; digits < most && !(scaled > std::fabs(number)); scaled *= 10) ++digits;
    return digits > 0 ? formatted("%.*g", digits, number) : formatted("0 +- %.0e by rounding", 10 * error);
}

// The sum of weights times values.
static std::string sum_of(const GaussianProcess& process, const std::vector<double>& values, int most) {
    const double error = rounding(process, process.weights, process.cholesky.solve(values));
    return right_digits(process.integral(values), error, most);
}

static std::string weights_block(const GaussianProcess& process) {
    std::string text = formatted("#%23s %24s %24s %12s %24s\n", "x", "y", "z", "z_j", "weight");
    const bool knows_cosine = process.known == Known::cosine;
    const double integral = known_integral(process.known),
                 gain = noise_gain({process.directions, process.weights, process.known});
    const std::vector<double> ones(process.z.size(), 1), parts(process.z.size(), 1 / integral);
    std::vector<double> white, squares;  // by which the weights sum to B, and to the gain^2 but for a factor
    int negative = 0;
    for (std::size_t i = 0; i < process.weights.size(); ++i) {
        const Vec3 omega = process.directions[i];
        const double weight = process.weights[i];
        text += formatted("%24.17g %24.17g %24.17g %12.9g %24.17g\n", omega.x, omega.y, omega.z, process.z[i], weight);
        negative += weight < 0;
        white.push_back((knows_cosine ? 1 : omega.y) / portable::pi);
        squares.push_back(white[i] * white[i] * weight);
    }
    const double error = rounding(process, process.weights, process.cholesky.solve(squares));
    return text + formatted(
                      R"(# The weights sum to %s, and the integral of %s is %.6g. The ratio %s would be 1 if the
# rule were exact for constants. Negative weights: %d.
# A white scene would render with the brightness B = %s instead of 1. The weights amplify the errors
# of samples %s times as much as Monte Carlo's do. Above 2, pictures are usually worse than Monte Carlo's.
# 17 digits give back the same doubles; ./workbench stability tells how many of a weight's digits are right.
)",
                      sum_of(process, ones, 6).c_str(), knows_cosine ? "cos(theta)" : "1", integral,
                      sum_of(process, parts, 4).c_str(), negative, sum_of(process, white, 4).c_str(),
                      right_digits(gain, gain * error / process.integral(squares), 3).c_str());
}

static std::string estimate_line(const GaussianProcess& process, const std::vector<double>& values) {
    const double bar = process.error_bar(values), amplitude = process.amplitude(values);
    if (!std::isfinite(amplitude) || std::isinf(bar))
        throw std::runtime_error("the values are too large for their squares; divide all by one number");
    // Half the relative errors of a^2 = Y^T Q^-1 Y / n and of V = zz - z^T Q^-1 z.
    const std::vector<double> solved = process.cholesky.solve(values);
    const double n = static_cast<double>(values.size()),
                 of_amplitude = rounding(process, solved, solved) / (2 * n * amplitude) / amplitude,
                 of_root = rounding(process, process.weights, process.weights) / (2 * process.variance);
    const double bar_error = bar * (of_amplitude + of_root);
    std::string bar_text = right_digits(bar, bar_error, 3) +
                           "\n# It knows what the samples have seen; a lamp that none of them met is not in it.";
    if (!(10 * bar_error <= bar))  // nor nan
        bar_text = "unknown: what is left of the variance may be rounding; more noise makes it larger";
    if (amplitude == 0) bar_text = "unknown: the values are 0, or too small to be squared";
    return formatted("# The integral of the values%s: estimate %s, amplitude %s, error bar ",
                     process.known == Known::cosine ? " times cos(theta)" : "", sum_of(process, values, 9).c_str(),
                     right_digits(amplitude, of_amplitude * amplitude, 6).c_str()) +
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
    std::string text = weights_block(process);
    if (!directions.empty())
        text += R"(# The weights are right if nobody looked at f to choose the directions. If some were drawn
# towards the light, an estimate may be far too bright: let f be the visibility, and the light a known factor.
)";
    if (!given.values.empty()) text += estimate_line(process, given.values);
    if (!matrices) return text;
    return text + matrix_block("Q", covariance_matrix(*covariance, settings.noise, given.directions)) +
           matrix_block("Q^-1", process.inverse_covariance());
}
}  // namespace bmc
