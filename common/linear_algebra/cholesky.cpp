#include "linear_algebra/cholesky.h"

#include "base/formatted.h"

namespace bmc {
// A pivot is a_mm minus m products. If it is smaller than m + 1 rounding errors of a_mm, it may be rounding error
// alone. The comparison refuses nan as well.
double root_of_pivot(const std::vector<double>& diagonal, std::size_t m, double pivot) {
    const double least = static_cast<double>(m + 1) * DBL_EPSILON * std::fabs(diagonal[m]);
    if (!(pivot > least))
        throw NotPositiveDefinite(
            formatted("the matrix of %zu rows is not positive definite: pivot %zu is %.3g; with more noise on its "
                      "diagonal, such as 0.1, it would be",
                      diagonal.size(), m + 1, pivot));
    return std::sqrt(pivot);
}

// BEGIN SOLUTION inverse
// As soon as row m of U is known, its products u_mi u_mj are subtracted from all rows i below. So when the turn of row
// i comes, it holds what is left of A. The innermost loop runs along a row. U takes the place of A.
static Matrix upper_factor(Matrix a, const std::vector<double>& diagonal) {
    const std::size_t n = a.rows;
    Matrix u = std::move(a);
    for (std::size_t m = 0; m < n; ++m) {
        u(m, m) = root_of_pivot(diagonal, m, u(m, m));
        for (std::size_t j = m + 1; j < n; ++j) u(m, j) /= u(m, m);
        for (std::size_t i = m + 1; i < n; ++i) {
            const double multiple = u(m, i);
            u(i, m) = 0;
            for (std::size_t j = i; j < n; ++j) u(i, j) -= multiple * u(m, j);
        }
    }
    return u;
}
// END SOLUTION

static Matrix checked_factor(Matrix a) {
    if (a.rows != a.columns) throw std::logic_error("cholesky: the matrix must be square");
    std::vector<double> diagonal;
    for (std::size_t m = 0; m < a.rows; ++m) diagonal.push_back(a(m, m));
    return upper_factor(std::move(a), diagonal);
}

Cholesky::Cholesky(Matrix a) : upper(checked_factor(std::move(a))) {}

// As in upper_factor: as soon as element m is known, its products are subtracted from all those below.
std::vector<double> Cholesky::forward_substitution(std::vector<double> b) const {
    if (b.size() != size()) throw std::logic_error("cholesky: the right-hand side must have one element per row");
    for (std::size_t m = 0; m < size(); ++m) {
        b[m] /= upper(m, m);
        for (std::size_t j = m + 1; j < size(); ++j) b[j] -= b[m] * upper(m, j);
    }
    return b;
}

std::vector<double> Cholesky::solve(std::vector<double> b) const {
    std::vector<double> x = forward_substitution(std::move(b));
    for (std::size_t m = size(); m-- > 0;) {  // from the last row up; an unsigned m >= 0 would never end
        for (std::size_t j = size() - 1; j > m; --j) x[m] -= upper(m, j) * x[j];
        x[m] /= upper(m, m);
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
