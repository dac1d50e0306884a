#include "cholesky.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace {

std::string describe_pivot(std::size_t index, double value, double rounding_error) {
    char text[160];
    std::snprintf(
        text, sizeof text,
        "the matrix is not positive definite: pivot %zu is %.3g, within its rounding error of %.2g; raise the noise",
        index, value, rounding_error);
    return text;
}

// y[first..n) -= factor * x[first..n): the inner loop of everything here.
void subtract_multiple(double factor, const double* x, double* y, std::size_t first, std::size_t n) {
    for (std::size_t j = first; j < n; ++j) y[j] -= factor * x[j];
}

}  // namespace

NotPositiveDefinite::NotPositiveDefinite(std::size_t pivot_index, double pivot_value, double rounding_error)
    : std::runtime_error(describe_pivot(pivot_index, pivot_value, rounding_error)),
      index(pivot_index),
      value(pivot_value) {}

Cholesky::Cholesky(Matrix a) : upper_(std::move(a)), reciprocal_(upper_.rows()) {
    const std::size_t n = upper_.rows();
    if (upper_.columns() != n) throw std::invalid_argument("cholesky: the matrix must be square");
    std::vector<double> rounding_error(n);
    for (std::size_t k = 0; k < n; ++k) rounding_error[k] = static_cast<double>(k + 1) * DBL_EPSILON * upper_(k, k);
    for (std::size_t k = 0; k < n; ++k) {
        double* row = upper_.row(k);
        if (!(row[k] > 0 && row[k] > rounding_error[k])) throw NotPositiveDefinite(k, row[k], rounding_error[k]);
        row[k] = std::sqrt(row[k]);
        reciprocal_[k] = 1 / row[k];
        for (std::size_t j = k + 1; j < n; ++j) row[j] *= reciprocal_[k];
        for (std::size_t i = k + 1; i < n; ++i) subtract_multiple(row[i], row, upper_.row(i), i, n);
        std::fill(row, row + k, 0.0);
    }
}

std::vector<double> Cholesky::solve_lower(std::vector<double> b) const {
    const std::size_t n = size();
    if (b.size() != n) throw std::invalid_argument("cholesky: the right-hand side must have one element per row");
    for (std::size_t k = 0; k < n; ++k) {
        b[k] *= reciprocal_[k];
        subtract_multiple(b[k], upper_.row(k), b.data(), k + 1, n);
    }
    return b;
}

std::vector<double> Cholesky::solve(std::vector<double> b) const {
    std::vector<double> x = solve_lower(std::move(b));
    for (std::size_t k = size(); k-- > 0;) {
        for (std::size_t j = size(); --j > k;) x[k] -= upper_(k, j) * x[j];
        x[k] *= reciprocal_[k];
    }
    return x;
}

Matrix Cholesky::inverse() const {
    const std::size_t n = size();
    Matrix lower(n, n);  // L^-1, row by row: l_kk (row k) = e_k - sum over i < k of l_ki (row i)
    for (std::size_t k = 0; k < n; ++k) {
        lower(k, k) += 1;
        for (std::size_t j = 0; j <= k; ++j) lower(k, j) *= reciprocal_[k];
        for (std::size_t i = k + 1; i < n; ++i) subtract_multiple(upper_(k, i), lower.row(k), lower.row(i), 0, k + 1);
    }
    Matrix result(n, n);  // A^-1 = L^-T L^-1
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t i = 0; i <= k; ++i) subtract_multiple(-lower(k, i), lower.row(k), result.row(i), 0, i + 1);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < i; ++j) result(j, i) = result(i, j);
    return result;
}

double Cholesky::log_determinant() const {
    double sum = 0;
    for (std::size_t k = 0; k < size(); ++k) sum += portable::log(upper_(k, k));
    return 2 * sum;
}
