#include "experiments/stability.h"

#include "quadrature/gaussian_process.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

using portable::pi;

namespace {

// c += factor * a^T b, n x n each, in strips of columns; two rows of sums at a time, which stay in registers.
// Of a triangular a only the upper triangle is read.
void add_transposed_product(double factor, const Matrix& a, bool triangular, const Matrix& b, Matrix& c) {
    constexpr std::size_t strip_width = 24;
    const std::size_t n = c.rows();
    std::vector<std::array<double, strip_width>> strip(n);
    for (std::size_t column = 0; column < n; column += strip_width) {
        const std::size_t columns = std::min(strip_width, n - column);
        for (std::size_t k = 0; k < n; ++k) std::copy_n(b.row(k) + column, columns, strip[k].begin());
        for (std::size_t row = 0; row < n; row += 2) {
            const std::size_t next = std::min(row + 1, n - 1);
            std::array<double, strip_width> sum{}, next_sum{};
            for (std::size_t k = 0; k < (triangular ? next + 1 : n); ++k) {
                const double multiple = a(k, row), next_multiple = a(k, next);
                for (std::size_t j = 0; j < strip_width; ++j) sum[j] += multiple * strip[k][j];
                for (std::size_t j = 0; j < strip_width; ++j) next_sum[j] += next_multiple * strip[k][j];
            }
            for (std::size_t j = 0; j < columns; ++j) c(row, column + j) += factor * sum[j];
            for (std::size_t j = 0; next > row && j < columns; ++j) c(next, column + j) += factor * next_sum[j];
        }
    }
}

// a + b without error (Knuth, "The Art of Computer Programming", volume 2, section 4.2.2, theorem B).
void two_sum(double a, double b, double& sum, double& error) {
    sum = a + b;
    const double part = sum - a;
    error = (a - (sum - part)) + (b - part);
}

// a * b without error (Dekker, "A floating-point technique for extending the available precision", Numerische
// Mathematik 18, 1971).
void two_product(double a, double b, double& product, double& error) {
    constexpr double split = 134217729;  // 2^27 + 1: half the bits of a factor at a time
    const double a_high = split * a - (split * a - a), b_high = split * b - (split * b - b);
    const double a_low = a - a_high, b_low = b - b_high;
    product = a * b;
    error = ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

// b - A x, A symmetric, every sum as the unevaluated sum of two doubles.
std::vector<double> residual(const Matrix& a, const std::vector<double>& x, const std::vector<double>& b) {
    const std::size_t n = b.size();
    std::vector<double> high = b, low(n);
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i) {
            double product, product_error, sum, sum_error;
            two_product(-x[j], a(j, i), product, product_error);
            two_sum(high[i], product, sum, sum_error);
            high[i] = sum;
            low[i] += sum_error + product_error;
        }
    for (std::size_t i = 0; i < n; ++i) high[i] += low[i];
    return high;
}

double largest(const std::vector<double>& x) {
    double size = 0;
    for (const double element : x) size = std::max(size, std::fabs(element));
    return size;
}

double relative_error(std::vector<double> x, const std::vector<double>& exact) {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] -= exact[i];
    return largest(x) / largest(exact);
}

std::string stability_line(const StabilityRow& row) {
    const std::string setting = line("%-11s %7zu %-19s %9g %6g ", name_of(row.set, sample_set_names), row.samples,
                                     row.model.name(), row.model.parameter, row.noise);
    if (!row.refusal.empty()) return "# " + setting + row.refusal + '\n';
    return "  " + setting +
           line("%10.3g %8.3f %8.3f %9.2g %9.2g %12.5g %10.3g\n", row.residuals.condition, row.residuals.factor,
                row.residuals.inverse, row.weight_error, row.inverse_error, row.absolute_weights, row.cosine_error);
}

// A setting that the factor accepts although less than one digit of its weights is right.
bool passes_unnoticed(const StabilityRow& row) { return row.refusal.empty() && !(row.weight_error < 0.1); }

std::string unnoticed(const std::vector<StabilityRow>& rows) {
    std::string text = "# The factor accepts these, and less than one digit of their weights is right:\n";
    for (const StabilityRow& row : rows)
        if (passes_unnoticed(row))
            text += line("#   %s, %zu samples, %s %g, noise %g, condition number %.1g\n",
                         name_of(row.set, sample_set_names), row.samples, row.model.name(), row.model.parameter,
                         row.noise, row.residuals.condition);
    return text;
}

// What noise to choose, from the rows: where nothing is refused, and what is left of 16 digits there.
std::string stability_verdict(const std::vector<StabilityRow>& rows) {
    double factor = 0, inverse = 0;
    for (const StabilityRow& row : rows) {
        factor = std::max(factor, row.residuals.factor);
        inverse = std::max(inverse, row.residuals.inverse);
    }
    std::string text =
        line("# The largest residual ratios are %.2g and %.2g: what is computed is as good as the matrix allows.\n",
             factor, inverse) +
        unnoticed(rows);
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
    const double a_norm = row_sum_norm(a), inverse_norm = row_sum_norm(inverse);
    const double unit = static_cast<double>(n) * DBL_EPSILON;
    Matrix identity_residual(n, n), factor_residual = a;
    for (std::size_t i = 0; i < n; ++i) identity_residual(i, i) = -1;
    add_transposed_product(-1, cholesky.upper(), true, cholesky.upper(), factor_residual);
    add_transposed_product(1, a, false, inverse, identity_residual);
    return {row_sum_norm(factor_residual) / (unit * a_norm),
            row_sum_norm(identity_residual) / (unit * a_norm * inverse_norm), a_norm * inverse_norm};
}

std::optional<std::vector<double>> refined_solution(const Matrix& a, const Cholesky& cholesky,
                                                    const std::vector<double>& b) {
    std::vector<double> x = cholesky.solve(b);
    for (double last = largest(x);;) {
        const std::vector<double> correction = cholesky.solve(residual(a, x, b));
        const double size = largest(correction);
        if (!(size < last / 2)) return std::nullopt;
        for (std::size_t i = 0; i < x.size(); ++i) x[i] += correction[i];
        if (size <= 2 * DBL_EPSILON * largest(x)) return x;
        last = size;
    }
}

StabilityRow examine(SampleSet set, std::size_t n, const Model& model, double noise) {
    StabilityRow row{set, n, model, noise, "", {0, 0, 0}, 0, 0, 0, 0};
    const std::vector<Vec3> directions = sample_set(set, n);
    try {
        const GaussianProcess process(*model.covariance, noise, directions);
        const Matrix inverse = process.inverse_covariance();
        const Matrix q = symmetric(covariance_matrix(*model.covariance, noise, directions));
        row.residuals = residuals_of(q, process.cholesky(), inverse);
        std::vector<double> by_inverse(n);
        double estimate = 0;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) by_inverse[i] += inverse(i, j) * process.z()[j];
            row.absolute_weights += std::fabs(process.weights()[i]);
            estimate += process.weights()[i] * directions[i].y;
        }
        const auto exact = refined_solution(q, process.cholesky(), process.z());
        row.weight_error = exact ? relative_error(process.weights(), *exact) : INFINITY;
        row.inverse_error = exact ? relative_error(by_inverse, *exact) : INFINITY;
        row.cosine_error = std::fabs(estimate - pi);
    } catch (const NotPositiveDefinite& error) {
        row.refusal = line("pivot %zu is %.3g", error.index, error.value);
    }
    return row;
}

std::vector<StabilityRow> stability_rows() {
    const std::vector<double> noises{1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-12, 0};
    std::vector<StabilityRow> rows;
    constexpr std::size_t counts[] = {1, 2, 10, 100, 1000};
    for (const std::size_t n : counts)
        for (const double noise : noises)
            rows.push_back(examine(SampleSet::random, n, {CovarianceFamily::sobolev, 1.5}, noise));
    std::vector<Model> models;
    for (const double s : {1.001, 1.1, 1.25, 1.75, 1.9, 1.999}) models.emplace_back(CovarianceFamily::sobolev, s);
    for (const double l : {0.05, 0.2, 1.0, 5.0, 100.0, 1e6})
        models.emplace_back(CovarianceFamily::squared_exponential, l);
    for (const Model& model : models)
        for (const double noise : noises) rows.push_back(examine(SampleSet::random, 100, model, noise));
    for (const SampleSet set : {SampleSet::duplicates, SampleSet::equator, SampleSet::pole, SampleSet::cluster})
        for (const Model& model :
             {Model(CovarianceFamily::sobolev, 1.5), Model(CovarianceFamily::squared_exponential, 1)})
            for (const double noise : noises) rows.push_back(examine(set, 100, model, noise));
    return rows;
}

std::string Stability::report() const {
    const std::vector<StabilityRow> rows = stability_rows();
    std::string text =
        "# Where the arithmetic breaks. factor and inverse: residuals over what backward stable arithmetic leaves\n"
        "# (LAPACK accepts 30); w_solve and w_inverse: largest error of the weights by the factor and by the inverse\n"
        "# over the largest weight, inf where none has a digit; a matrix that the factor refuses is in a comment.\n"
        "# set         samples covariance          parameter  noise  condition   factor  inverse   w_solve w_inverse "
        "     sum_|w|  cos_error\n";
    for (const StabilityRow& row : rows) text += stability_line(row);
    return text + stability_verdict(rows);
}
