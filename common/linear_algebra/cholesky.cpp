#include "linear_algebra/cholesky.h"

#include "base/formatted.h"

#include <algorithm>

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

// U with U^T U = A. The diagonal of A is there for root_of_pivot, which gives each u_mm: a plain square root would let
// a pivot pass that is only rounding error, and with it weights of any size, or nan.
// BEGIN SOLUTION inverse
// U takes the place of A: as soon as row m of U is known, its products are subtracted from the rows below, so that each
// row holds what is left of A when its turn comes. The plain loop is
//     for each row m:  u_mm = root_of_pivot(u_mm);  u_mj /= u_mm for j > m;  u_ij -= u_mi u_mj for i > m, j >= i
// What is below a block of eight rows waits here until all eight are known, so that each element comes from memory once
// for eight products: from 200 rows on that takes half the time. Their order, and so each rounding, stays the same.
static Matrix upper_factor(Matrix a, const std::vector<double>& diagonal) {
    constexpr std::size_t block = 8;
    const std::size_t n = a.rows;
    Matrix u = std::move(a);
    for (std::size_t begin = 0; begin < n; begin += block) {
        const std::size_t end = std::min(begin + block, n);
        for (std::size_t m = begin; m < end; ++m) {
            std::fill(&u(m, 0), &u(m, m), 0.0);
            u(m, m) = root_of_pivot(diagonal, m, u(m, m));
            for (std::size_t j = m + 1; j < n; ++j) u(m, j) /= u(m, m);
            for (std::size_t i = m + 1; i < end; ++i) {
                const double multiple = u(m, i);
                for (std::size_t j = i; j < n; ++j) u(i, j) -= multiple * u(m, j);
            }
        }
        for (std::size_t i = end; i < n; ++i) {
            double multiples[block];
            for (std::size_t k = 0; k < block; ++k) multiples[k] = u(begin + k, i);
            for (std::size_t j = i; j < n; ++j) {
                double left = u(i, j);
                for (std::size_t k = 0; k < block; ++k) left -= multiples[k] * u(begin + k, j);
                u(i, j) = left;
            }
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
// All columns at once, each as in solve: first G with U^T G = 1, which is zero above its diagonal, then U X = G.
Matrix Cholesky::inverse() const {
    Matrix x(size(), size());
    for (std::size_t m = 0; m < size(); ++m) {
        x(m, m) = 1;
        for (std::size_t k = 0; k <= m; ++k) x(m, k) /= upper(m, m);
        for (std::size_t j = m + 1; j < size(); ++j)
            for (std::size_t k = 0; k <= m; ++k) x(j, k) -= upper(m, j) * x(m, k);
    }
    for (std::size_t m = size(); m-- > 0;) {
        for (std::size_t j = size() - 1; j > m; --j)
            for (std::size_t k = 0; k < size(); ++k) x(m, k) -= upper(m, j) * x(j, k);
        for (std::size_t k = 0; k < size(); ++k) x(m, k) /= upper(m, m);
    }
    return x;
}
// END SOLUTION
}  // namespace bmc
