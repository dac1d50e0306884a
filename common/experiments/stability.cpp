#include "experiments/stability.h"

#include "experiments/exact_weights.h"
#include "quadrature/gaussian_process.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

using portable::pi;

namespace {

// |a - b^T c|, n x n each.
double residual_norm(Matrix a, const Matrix& b, const Matrix& c) {
    const std::size_t n = a.rows();
    for (std::size_t i = 0; i < n; ++i) {
        std::vector<double> sum(n);
        for (std::size_t k = 0; k < n; ++k) {
            const double multiple = b(k, i);
            if (multiple == 0) continue;  // half of a factor
            for (std::size_t j = 0; j < n; ++j) sum[j] += multiple * c(k, j);
        }
        for (std::size_t j = 0; j < n; ++j) a(i, j) -= sum[j];
    }
    return row_sum_norm(a);
}

double relative_error(std::vector<double> x, const std::optional<std::vector<double>>& exact) {
    if (!exact) return INFINITY;
    for (std::size_t i = 0; i < x.size(); ++i) x[i] -= (*exact)[i];
    return largest(x) / largest(*exact);
}

constexpr double noises[] = {1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-12, 0};

std::string setting(const StabilityRow& row) {
    return line("%-11s %7zu %-19s %9g ", name_of(row.set, sample_set_names), row.samples, row.model.name(),
                row.model.parameter);
}

std::string stability_line(const StabilityRow& row) {
    const std::string text = setting(row) + line("%6g ", row.noise);
    if (!row.refusal.empty()) return "# " + text + row.refusal + '\n';
    const std::string errors = line("%12.5g %10.3g\n", row.absolute_weights, row.cosine_error);
    if (row.residuals.condition == 0)
        return "  " + text + line("%10s %8s %8s %9.2g %9s ", "-", "-", "-", row.weight_error, "-") + errors;
    return "  " + text +
           line("%10.3g %8.3f %8.3f %9.2g %9.2g ", row.residuals.condition, row.residuals.factor, row.residuals.inverse,
                row.weight_error, row.inverse_error) +
           errors;
}

// How many decimal digits an error leaves of the 16 that a double has.
int digits_of(double error) {
    if (!(error > 1e-16)) return 16;
    return static_cast<int>(std::max(0.0, std::floor(-portable::log(error) / portable::log(10))));
}

// The digits of the weights: a line for each setting, a column for each noise. Rows of one setting follow each other.
std::string digits_table(const std::vector<StabilityRow>& rows) {
    std::string text =
        "# How many of 16 digits of the weights are right, at a noise of\n"
        "# set         samples covariance          parameter     1 0.01 1e-4 1e-6 1e-8 1e-12    0\n";
    for (std::size_t i = 0; i < rows.size();) {
        const std::string name = setting(rows[i]);
        text += "  " + name;
        for (const double noise : noises) {
            if (i == rows.size() || setting(rows[i]) != name || rows[i].noise != noise)
                text += line("%5s", "?");
            else if (const StabilityRow& row = rows[i++]; !row.refusal.empty())
                text += line("%5s", "-");
            else
                text += line("%5d", digits_of(row.weight_error));
        }
        text += '\n';
    }
    return text + "# -: the factor refuses the matrix; ?: not tried\n";
}

// What noise to choose, from the rows: where nothing is refused, and what is left of 16 digits there.
std::string stability_verdict(const std::vector<StabilityRow>& rows) {
    Residuals most;
    for (const StabilityRow& row : rows) {
        most.factor = std::max(most.factor, row.residuals.factor);
        most.inverse = std::max(most.inverse, row.residuals.inverse);
    }
    std::string text =
        line("# The largest residual ratios are %.2g and %.2g: what is computed is as good as the matrix allows.\n",
             most.factor, most.inverse) +
        "# The factor accepts these, and less than one digit of their weights is right:\n";
    for (const StabilityRow& row : rows)
        if (row.refusal.empty() && !(row.weight_error < 0.1))
            text += "#   " + setting(row) + line("noise %g\n", row.noise);
    double chosen = 1;
    for (const double noise : {1e-2, 1e-4, 1e-6, 1e-8}) {
        double condition = 0, error = 0;
        int refused = 0;
        for (const StabilityRow& row : rows) {
            if (row.noise != noise) continue;
            refused += !row.refusal.empty();
            condition = std::max(condition, row.residuals.condition);
            error = std::max(error, row.weight_error);
        }
        text += line(
            "# Noise %g: %d settings are refused; the others have condition numbers up to %.1g and weights\n"
            "#   that are wrong by up to %.1g of the largest.\n",
            noise, refused, condition, error);
        if (refused == 0 && error < 1e-6) chosen = noise;
    }
    return text + line("# %g is the least noise here with which nothing is refused and every weight has six digits.\n",
                       chosen);
}

std::vector<double> product(const Matrix& a, const std::vector<double>& x) {
    std::vector<double> b(a.rows());
    for (std::size_t i = 0; i < a.rows(); ++i)
        for (std::size_t j = 0; j < x.size(); ++j) b[i] += a(i, j) * x[j];
    return b;
}

}  // namespace

std::vector<Vec3> sample_set(SampleSet set, std::size_t n) {
    Random random(1, n);
    std::vector<Vec3> directions = uniform_directions(n, random);
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 d = directions[i];
        switch (set) {
            case SampleSet::random: break;
            case SampleSet::duplicates: directions[i] = directions[i / 2 * 2]; break;
            case SampleSet::equator: directions[i] = normalize({d.x, 0, d.z}); break;
            case SampleSet::pole: directions[i] = {0, 1, 0}; break;
            case SampleSet::cluster: directions[i] = normalize(Vec3{0.48, 0.6, 0.64} + 1e-8 * d); break;
        }
    }
    return directions;
}

Residuals residuals_of(const Matrix& a, const Cholesky& cholesky, const Matrix& inverse) {
    const std::size_t n = a.rows();
    const double a_norm = row_sum_norm(a), condition = a_norm * row_sum_norm(inverse);
    const double unit = static_cast<double>(n) * DBL_EPSILON;
    Matrix identity(n, n);
    for (std::size_t i = 0; i < n; ++i) identity(i, i) = 1;
    return {residual_norm(a, cholesky.upper(), cholesky.upper()) / (unit * a_norm),
            residual_norm(identity, a, inverse) / (unit * condition), condition};
}

std::vector<StabilityRow> examine(SampleSet set, std::size_t n, const Model& model, const std::vector<double>& tried) {
    const std::vector<Vec3> directions = sample_set(set, n);
    const ExactWeights exact(model, directions);
    std::vector<StabilityRow> rows;
    for (const double noise : tried) {
        StabilityRow row{set, n, model, noise};
        try {
            const GaussianProcess process(*model.covariance, noise, directions);
            const std::vector<double>& weights = process.weights();
            const auto right = exact.weights(noise, process.cholesky());
            row.weight_error = relative_error(weights, right);
            double estimate = 0;
            for (std::size_t i = 0; i < n; ++i) {
                row.absolute_weights += std::fabs(weights[i]);
                estimate += weights[i] * directions[i].y;
            }
            row.cosine_error = std::fabs(estimate - pi);
            if (n <= 1000) {
                const Matrix q = symmetric(covariance_matrix(*model.covariance, noise, directions)),
                             inverse = process.inverse_covariance();
                row.residuals = residuals_of(q, process.cholesky(), inverse);
                row.inverse_error = relative_error(product(inverse, process.z()), right);
            }
        } catch (const NotPositiveDefinite& error) {
            row.refusal = line("pivot %zu is %.3g", error.index, error.value);
        }
        rows.push_back(row);
    }
    return rows;
}

namespace {

// The sweeps: samples and noise; covariance and noise; sample set and noise.
std::vector<StabilityRow> stability_rows() {
    std::vector<StabilityRow> rows;
    const auto add = [&rows](SampleSet set, std::size_t n, const Model& model, std::vector<double> tried = {}) {
        if (tried.empty()) tried.assign(std::begin(noises), std::end(noises));
        for (StabilityRow& row : examine(set, n, model, tried)) rows.push_back(std::move(row));
    };
    const Model rough(CovarianceFamily::sobolev, 1.5), smooth(CovarianceFamily::squared_exponential, 1);
    for (const std::size_t n : {1u, 2u, 10u, 100u, 1000u}) add(SampleSet::random, n, rough);
    for (const double s : {1.001, 1.1, 1.25, 1.75, 1.9, 1.999})
        add(SampleSet::random, 100, {CovarianceFamily::sobolev, s});
    for (const double l : {0.05, 0.2, 1.0, 5.0, 100.0, 1e6})
        add(SampleSet::random, 100, {CovarianceFamily::squared_exponential, l});
    for (const SampleSet set : {SampleSet::duplicates, SampleSet::equator, SampleSet::pole, SampleSet::cluster})
        for (const Model& model : {rough, smooth}) add(set, 100, model);
    add(SampleSet::cluster, 4096, rough, {1e-2, 1e-4});
    return rows;
}

}  // namespace

std::vector<Option> Stability::options() {
    return {{"all", "", "also every setting with its residuals", [this](const std::string&) { all = true; }}};
}

std::string Stability::report() const {
    const std::vector<StabilityRow> rows = stability_rows();
    std::string text =
        "# Where the arithmetic breaks: the weights of a double against those with 32 digits, from the directions "
        "on.\n" +
        digits_table(rows) + stability_verdict(rows);
    if (!all) return text;
    text +=
        "\n\n# factor and inverse: residuals over what backward stable arithmetic leaves (LAPACK accepts 30); "
        "by_factor\n"
        "# and by_inverse: largest error of the weights over the largest weight, inf where none has a digit; a matrix "
        "that\n"
        "# the factor refuses is in a comment.\n"
        "# set         samples covariance          parameter  noise  condition   factor  inverse by_factor by_inverse"
        "     sum_|w|  cos_error\n";
    for (const StabilityRow& row : rows) text += stability_line(row);
    return text;
}
