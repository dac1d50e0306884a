#include "numerics/cholesky.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace {

std::string describe_pivot(std::size_t index, double value, double least) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "the matrix is not positive definite: pivot %zu is %.3g and must exceed %.2g; raise the noise", index,
                  value, least);
    return text;
}

// How often source row k is subtracted from target row i: elements of U, along a column or along a row.
struct Multiples {
    const Matrix& upper;
    bool transposed;

    double operator()(std::size_t k, std::size_t i) const { return transposed ? upper(k, i) : upper(i, k); }
};

// Subtracts multiples of the rows k, k + 1, ... of x from its rows i, i + 1, ..., in this order, in the columns
// [first, last). An element of a target stays in a register for all sources, an element of a source serves all targets:
// otherwise the loop would wait for memory. The counts are constants, so that the loop over j is the only one left, and
// not larger, so that compilers still prove the rows apart.
template <std::size_t sources, std::size_t targets>
void subtract_rows(Matrix& x, std::size_t k, std::size_t i, const Multiples& multiples, std::size_t first,
                   std::size_t last) {
    const double* source[sources];
    double* target[targets];
    double factor[sources][targets];
    for (std::size_t s = 0; s < sources; ++s) source[s] = x.row(k + s);
    for (std::size_t t = 0; t < targets; ++t) target[t] = x.row(i + t);
    for (std::size_t s = 0; s < sources; ++s)
        for (std::size_t t = 0; t < targets; ++t) factor[s][t] = multiples(k + s, i + t);
    for (std::size_t j = first; j < last; ++j) {
        double sum[targets];
        for (std::size_t t = 0; t < targets; ++t) sum[t] = target[t][j];
        for (std::size_t s = 0; s < sources; ++s)
            for (std::size_t t = 0; t < targets; ++t) sum[t] -= factor[s][t] * source[s][j];
        for (std::size_t t = 0; t < targets; ++t) target[t][j] = sum[t];
    }
}

// The same for all source rows [begin, end).
template <std::size_t targets>
void eliminate(Matrix& x, std::size_t begin, std::size_t end, std::size_t i, const Multiples& multiples,
               std::size_t first, std::size_t last) {
    std::size_t k = begin;
    for (; k + 3 <= end; k += 3) subtract_rows<3, targets>(x, k, i, multiples, first, last);
    for (; k < end; ++k) subtract_rows<1, targets>(x, k, i, multiples, first, last);
}

void divide(double* row, double divisor, std::size_t first, std::size_t last) {
    const double reciprocal = 1 / divisor;
    for (std::size_t j = first; j < last; ++j) row[j] *= reciprocal;
}

// Row k of A, less the multiples of the rows above, becomes row k of the factor.
void finish_row(Matrix& upper, std::size_t k, double diagonal) {
    double* row = upper.row(k);
    const double least = static_cast<double>(k + 1) * DBL_EPSILON * std::fabs(diagonal);
    if (!(row[k] > least)) throw NotPositiveDefinite(k, row[k], least);
    row[k] = std::sqrt(row[k]);
    divide(row, row[k], k + 1, upper.columns());
    std::fill(row, row + k, 0.0);
}

template <std::size_t rows>
void factor_rows(Matrix& upper, std::size_t i) {
    const Multiples multiples{upper, true};
    const std::size_t n = upper.rows();
    double diagonal[rows];
    for (std::size_t r = 0; r < rows; ++r) diagonal[r] = upper(i + r, i + r);
    eliminate<rows>(upper, 0, i, i, multiples, i, n);
    for (std::size_t r = 0; r < rows; ++r) {
        eliminate<1>(upper, i, i + r, i + r, multiples, i + r, n);
        finish_row(upper, i + r, diagonal[r]);
    }
}

// The rows i, i + 1, ... of Y from those before, where L Y = X; Y is lower triangular because X = I.
template <std::size_t rows>
void substitute_forward(const Matrix& upper, Matrix& x, std::size_t i) {
    const Multiples multiples{upper, true};
    eliminate<rows>(x, 0, i, i, multiples, 0, i);
    for (std::size_t r = 0; r < rows; ++r) {
        eliminate<1>(x, i, i + r, i + r, multiples, 0, i + r);
        divide(x.row(i + r), upper(i + r, i + r), 0, i + r + 1);
    }
}

// The rows i, i + 1, ... of X from those after, where U X = Y.
template <std::size_t rows>
void substitute_back(const Matrix& upper, Matrix& x, std::size_t i) {
    const Multiples multiples{upper, false};
    const std::size_t n = x.columns();
    eliminate<rows>(x, i + rows, n, i, multiples, 0, n);
    for (std::size_t r = rows; r-- > 0;) {
        eliminate<1>(x, i + r + 1, i + rows, i + r, multiples, 0, n);
        divide(x.row(i + r), upper(i + r, i + r), 0, n);
    }
}

}  // namespace

NotPositiveDefinite::NotPositiveDefinite(std::size_t pivot_index, double pivot_value, double least)
    : std::runtime_error(describe_pivot(pivot_index, pivot_value, least)), index(pivot_index), value(pivot_value) {}

NotPositiveDefinite::NotPositiveDefinite(const std::string& subject, const NotPositiveDefinite& error)
    : std::runtime_error(subject + error.what()), index(error.index), value(error.value) {}

Cholesky::Cholesky(Matrix a) : upper_(std::move(a)) {
    const std::size_t n = upper_.rows();
    if (upper_.columns() != n) throw std::invalid_argument("cholesky: the matrix must be square");
    std::size_t i = 0;
    for (; i + 2 <= n; i += 2) factor_rows<2>(upper_, i);
    if (i < n) factor_rows<1>(upper_, i);
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

// By symmetry the back substitution need only compute half of every row; but an inverse whose columns mix several
// solutions has residuals far above rounding where A is nearly singular.
Matrix Cholesky::inverse() const {
    const std::size_t n = size();
    Matrix x(n, n);
    for (std::size_t i = 0; i < n; ++i) x(i, i) = 1;
    std::size_t i = 0;
    for (; i + 2 <= n; i += 2) substitute_forward<2>(upper_, x, i);
    if (i < n) substitute_forward<1>(upper_, x, i);
    for (i = n; i >= 2; i -= 2) substitute_back<2>(upper_, x, i - 2);
    if (i > 0) substitute_back<1>(upper_, x, 0);
    return x;
}

double Cholesky::log_determinant() const {
    double sum = 0;
    for (std::size_t k = 0; k < size(); ++k) sum += portable::log(upper_(k, k));
    return 2 * sum;
}
