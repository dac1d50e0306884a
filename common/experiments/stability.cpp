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

Model sobolev(double s) { return {"sobolev", s, std::make_shared<Sobolev>(s)}; }

Model squared_exponential(double l) { return {"squared-exponential", l, std::make_shared<SquaredExponential>(l)}; }

}  // namespace

const char* name_of(SampleSet set) {
    switch (set) {
        case SampleSet::random: return "random";
        case SampleSet::duplicates: return "duplicates";
        case SampleSet::equator: return "equator";
        case SampleSet::pole: return "pole";
        case SampleSet::cluster: return "cluster";
    }
    return "";
}

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
        for (const double noise : noises) rows.push_back(examine(SampleSet::random, n, sobolev(1.5), noise));
    std::vector<Model> models;
    for (const double s : {1.001, 1.1, 1.25, 1.75, 1.9, 1.999}) models.push_back(sobolev(s));
    for (const double l : {0.05, 0.2, 1.0, 5.0, 100.0, 1e6}) models.push_back(squared_exponential(l));
    for (const Model& model : models)
        for (const double noise : noises) rows.push_back(examine(SampleSet::random, 100, model, noise));
    for (const SampleSet set : {SampleSet::duplicates, SampleSet::equator, SampleSet::pole, SampleSet::cluster})
        for (const Model& model : {sobolev(1.5), squared_exponential(1)})
            for (const double noise : noises) rows.push_back(examine(set, 100, model, noise));
    return rows;
}
