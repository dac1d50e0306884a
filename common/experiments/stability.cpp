#include "experiments/stability.h"

#include "quadrature/gaussian_process.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

using portable::pi;

namespace {

// c += factor * a^T b
void add_transposed_product(double factor, const Matrix& a, const Matrix& b, Matrix& c) {
    for (std::size_t i = 0; i < c.rows(); ++i)
        for (std::size_t k = 0; k < a.rows(); ++k) {
            const double multiple = factor * a(k, i);
            if (multiple == 0) continue;  // a triangle's other half
            const double* from = b.row(k);
            double* to = c.row(i);
            for (std::size_t j = 0; j < c.columns(); ++j) to[j] += multiple * from[j];
        }
}

std::string stability_line(const StabilityRow& row) {
    const std::string setting = line("%-11s %7zu %-19s %9g %6g ", name_of(row.set, sample_set_names), row.samples,
                                     row.model.name(), row.model.parameter, row.noise);
    if (!row.refusal.empty()) return "# " + setting + row.refusal + '\n';
    return "  " + setting +
           line("%10.3g %8.3f %8.3f %10.2g %12.5g %10.3g\n", row.residuals.condition, row.residuals.factor,
                row.residuals.inverse, row.weight_difference, row.absolute_weights, row.cosine_error);
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
             factor, inverse);
    double chosen = 1;
    for (const double noise : {1e-2, 1e-4, 1e-6, 1e-8}) {
        double condition = 0, difference = 0;
        int refused = 0;
        for (const StabilityRow& row : rows) {
            if (row.noise != noise) continue;
            condition = std::max(condition, row.residuals.condition);
            difference = std::max(difference, row.weight_difference);
            refused += !row.refusal.empty();
        }
        text += line(
            "# Noise %g: %d settings are refused, the others have condition numbers up to %.1g and weights that solve "
            "and\n"
            "#   inverse agree on to %.1g.\n",
            noise, refused, condition, difference);
        if (refused == 0 && difference < 1e-6) chosen = noise;
    }
    return text +
           line("# Choose %g: the least noise here with which nothing is refused and every weight has six digits.\n",
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

Residuals residuals_of(const Matrix& upper_triangle, const Cholesky& cholesky, const Matrix& inverse) {
    const std::size_t n = upper_triangle.rows();
    Matrix a = upper_triangle;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j) a(i, j) = a(j, i);
    const double a_norm = row_sum_norm(a), inverse_norm = row_sum_norm(inverse);
    const double unit = static_cast<double>(n) * DBL_EPSILON;
    Matrix identity_residual(n, n), factor_residual = a;
    for (std::size_t i = 0; i < n; ++i) identity_residual(i, i) = -1;
    add_transposed_product(-1, cholesky.upper(), cholesky.upper(), factor_residual);
    add_transposed_product(1, a, inverse, identity_residual);
    return {row_sum_norm(factor_residual) / (unit * a_norm),
            row_sum_norm(identity_residual) / (unit * a_norm * inverse_norm), a_norm * inverse_norm};
}

StabilityRow examine(SampleSet set, std::size_t n, const Model& model, double noise) {
    StabilityRow row{set, n, model, noise, "", {0, 0, 0}, 0, 0, 0};
    const std::vector<Vec3> directions = sample_set(set, n);
    try {
        const GaussianProcess process(*model.covariance, noise, directions);
        const Matrix inverse = process.inverse_covariance();
        row.residuals =
            residuals_of(covariance_matrix(*model.covariance, noise, directions), process.cholesky(), inverse);
        double largest = 0, estimate = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const double weight = process.weights()[i];
            double by_inverse = 0;
            for (std::size_t j = 0; j < n; ++j) by_inverse += inverse(i, j) * process.z()[j];
            row.weight_difference = std::max(row.weight_difference, std::fabs(by_inverse - weight));
            largest = std::max(largest, std::fabs(weight));
            row.absolute_weights += std::fabs(weight);
            estimate += weight * directions[i].y;
        }
        row.weight_difference /= largest;
        row.cosine_error = std::fabs(estimate - pi);
    } catch (const NotPositiveDefinite& error) {
        row.refusal = error.what();
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
        "# Where the arithmetic breaks. factor and inverse: residuals over what backward stable arithmetic leaves "
        "(LAPACK\n"
        "# accepts 30); difference: of the weights by solve and by inverse; a set that double precision cannot tell "
        "from a\n"
        "# singular one is refused, in a comment.\n"
        "# set         samples covariance          parameter  noise  condition   factor  inverse difference      "
        "sum_|w|  cos_error\n";
    for (const StabilityRow& row : rows) text += stability_line(row);
    return text + stability_verdict(rows);
}
