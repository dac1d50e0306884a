#include "linear_algebra/cholesky.h"

#include "numerics/formatted.h"

namespace bmc {
double root_of_pivot(const Matrix& a, std::size_t k, double pivot) {
    const double least = static_cast<double>(k + 1) * DBL_EPSILON * std::fabs(a(k, k));
    if (!(pivot > least))
        throw NotPositiveDefinite(
            formatted("the matrix of %zu rows is not positive definite: pivot %zu is %.3g", a.rows(), k, pivot));
    return std::sqrt(pivot);
}

// BEGIN SOLUTION inverse
// As soon as row k of U is known, its products u_ki u_kj are subtracted from all rows i below: each row has then had
// its sum subtracted when its turn comes. The innermost loop runs along a row.
static Matrix upper_factor(const Matrix& a) {
    const std::size_t n = a.rows();
    Matrix u = a;
    for (std::size_t k = 0; k < n; ++k) {
        u(k, k) = root_of_pivot(a, k, u(k, k));
        for (std::size_t j = k + 1; j < n; ++j) u(k, j) /= u(k, k);
        for (std::size_t i = k + 1; i < n; ++i) {
            const double multiple = u(k, i);
            u(i, k) = 0;
            for (std::size_t j = i; j < n; ++j) u(i, j) -= multiple * u(k, j);
        }
    }
    return u;
}
// END SOLUTION

Cholesky::Cholesky(const Matrix& a) : upper_(0, 0) {
    if (a.rows() != a.columns()) throw std::invalid_argument("cholesky: the matrix must be square");
    upper_ = upper_factor(a);
}

std::vector<double> Cholesky::forward_substitution(std::vector<double> b) const {
    if (b.size() != size()) throw std::invalid_argument("cholesky: the right-hand side must have one element per row");
    for (std::size_t k = 0; k < size(); ++k) {
        b[k] /= upper_(k, k);
        for (std::size_t j = k + 1; j < size(); ++j) b[j] -= b[k] * upper_(k, j);
    }
    return b;
}

std::vector<double> Cholesky::solve(std::vector<double> b) const {
    std::vector<double> x = forward_substitution(std::move(b));
    for (std::size_t k = size(); k-- > 0;) {  // from the last row up
        for (std::size_t j = size() - 1; j > k; --j) x[k] -= upper_(k, j) * x[j];
        x[k] /= upper_(k, k);
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
}  // namespace bmc
