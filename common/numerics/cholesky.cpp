#include "numerics/cholesky.h"

#include "numerics/cholesky_fast.h"
#include "numerics/formatted.h"
#include "numerics/plain_loops.h"

#include <algorithm>
#include <cmath>

namespace bmc {
NotPositiveDefinite::NotPositiveDefinite(std::size_t pivot_index, double pivot_value, double least)
    : std::runtime_error(formatted("the matrix is not positive definite: pivot %zu is %.3g and must exceed %.2g; raise "
                                   "the noise",
                                   pivot_index, pivot_value, least)),
      index(pivot_index),
      value(pivot_value) {}

double root_of_pivot(std::size_t k, double pivot, double a_kk) {
    const double least = static_cast<double>(k + 1) * DBL_EPSILON * std::fabs(a_kk);
    if (!(pivot > least)) throw NotPositiveDefinite(k, pivot, least);
    return std::sqrt(pivot);
}

namespace {

// U in place of the upper triangle of A, row after row.
// BEGIN SOLUTION inverse
void factor(Matrix& u) {
    if (!plain_loops) return factor_fast(u);
    for (std::size_t k = 0; k < u.rows(); ++k) {
        const double a_kk = u(k, k);
        for (std::size_t i = 0; i < k; ++i)
            for (std::size_t j = k; j < u.rows(); ++j) u(k, j) -= u(i, k) * u(i, j);
        const double u_kk = root_of_pivot(k, u(k, k), a_kk);
        for (std::size_t j = k + 1; j < u.rows(); ++j) u(k, j) *= 1 / u_kk;
        u(k, k) = u_kk;
    }
}
// END SOLUTION

}  // namespace

Cholesky::Cholesky(Matrix a) : upper_(std::move(a)) {
    if (upper_.columns() != size()) throw std::invalid_argument("cholesky: the matrix must be square");
    factor(upper_);
    for (std::size_t i = 0; i < size(); ++i) std::fill(upper_.row(i), upper_.row(i) + i, 0.0);
}

std::vector<double> Cholesky::solve_lower(std::vector<double> b) const {
    const std::size_t n = size();
    if (b.size() != n) throw std::invalid_argument("cholesky: the right-hand side must have one element per row");
    for (std::size_t k = 0; k < n; ++k) {
        b[k] *= 1 / upper_(k, k);
        for (std::size_t j = k + 1; j < n; ++j) b[j] -= b[k] * upper_(k, j);
    }
    return b;
}

std::vector<double> Cholesky::solve(std::vector<double> b) const {
    std::vector<double> x = solve_lower(std::move(b));
    for (std::size_t k = size(); k-- > 0;) {
        for (std::size_t j = size(); --j > k;) x[k] -= upper_(k, j) * x[j];
        x[k] *= 1 / upper_(k, k);
    }
    return x;
}

// BEGIN SOLUTION inverse
Matrix Cholesky::inverse() const {
    Matrix inverse(size(), size());
    for (std::size_t j = 0; j < size(); ++j) {
        std::vector<double> e(size());
        e[j] = 1;
        const std::vector<double> column = solve(std::move(e));
        for (std::size_t i = 0; i < size(); ++i) inverse(i, j) = column[i];
    }
    return inverse;
}
// END SOLUTION

double Cholesky::log_determinant() const {
    double sum = 0;
    for (std::size_t k = 0; k < size(); ++k) sum += portable::log(upper_(k, k));
    return 2 * sum;
}
}  // namespace bmc
