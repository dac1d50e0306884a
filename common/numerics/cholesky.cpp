#include "numerics/cholesky.h"

#include <algorithm>
#include <array>
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

}  // namespace

NotPositiveDefinite::NotPositiveDefinite(std::size_t pivot_index, double pivot_value, double least)
    : std::runtime_error(describe_pivot(pivot_index, pivot_value, least)), index(pivot_index), value(pivot_value) {}

NotPositiveDefinite::NotPositiveDefinite(const std::string& subject, const NotPositiveDefinite& error)
    : std::runtime_error(subject + error.what()), index(error.index), value(error.value) {}

// BEGIN SOLUTION inverse
namespace {

// So many columns are worked on at a time, side by side in a strip that has a row for each row of the matrix: narrow
// enough for the caches, wide enough for compilers to see a loop in a row.
constexpr std::size_t width = 24;
using Row = std::array<double, width>;
using Strip = std::vector<Row>;

void subtract(double multiple, const Row& source, Row& target) {
    for (std::size_t c = 0; c < width; ++c) target[c] -= multiple * source[c];
}

void divide(Row& row, double divisor) {
    const double reciprocal = 1 / divisor;
    for (double& element : row) element *= reciprocal;
}

// How often row k = 0, 1, ... of a strip is subtracted from one row and from another: numbers stride apart.
struct Multiples {
    const double *first, *second;
    std::size_t stride;
};

// Subtracts multiples of the rows k = begin, ..., end - 1 of the strip, in this order, from its row i and, if there are
// two, from row i + 1. The two are copies, so that they stay in registers: otherwise the loop would wait for memory.
void eliminate(Strip& x, std::size_t begin, std::size_t end, std::size_t i, bool two, Multiples multiples) {
    const auto [a, b, stride] = multiples;
    if (!two) {
        for (std::size_t k = begin; k < end; ++k) subtract(a[k * stride], x[k], x[i]);
        return;
    }
    Row first = x[i], second = x[i + 1];
    for (std::size_t k = begin; k < end; ++k) {
        const Row& source = x[k];
        subtract(a[k * stride], source, first);
        subtract(b[k * stride], source, second);
    }
    x[i] = first;
    x[i + 1] = second;
}

// The rows [begin, end) of Y, where L Y = X, in place of X; Y is 0 above them.
void substitute_forward(const Matrix& upper, Strip& x, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; i += 2) {
        const bool two = i + 1 < end;
        eliminate(x, begin, i, i, two, {upper.row(0) + i, upper.row(0) + i + 1, upper.columns()});
        divide(x[i], upper(i, i));
        if (!two) break;
        subtract(upper(i, i + 1), x[i], x[i + 1]);
        divide(x[i + 1], upper(i + 1, i + 1));
    }
}

// X, where U X = Y, in place of Y.
void substitute_back(const Matrix& upper, Strip& x) {
    std::size_t i = x.size();
    for (; i >= 2; i -= 2) {
        eliminate(x, i, x.size(), i - 2, true, {upper.row(i - 2), upper.row(i - 1), 1});
        divide(x[i - 1], upper(i - 1, i - 1));
        subtract(upper(i - 2, i - 1), x[i - 1], x[i - 2]);
        divide(x[i - 2], upper(i - 2, i - 2));
    }
    if (i == 0) return;
    eliminate(x, 1, x.size(), 0, false, {upper.row(0), nullptr, 1});
    divide(x[0], upper(0, 0));
}

// Row i of the strip that begins at column j, in which row i of A is less the multiples of the rows above, becomes row
// i of the factor.
void finish_row(Strip& x, std::size_t i, std::size_t j, double diagonal) {
    const double pivot = x[i][i - j], least = static_cast<double>(i + 1) * DBL_EPSILON * std::fabs(diagonal);
    if (!(pivot > least)) throw NotPositiveDefinite(i, pivot, least);
    divide(x[i], std::sqrt(pivot));
    x[i][i - j] = std::sqrt(pivot);
    std::fill(x[i].begin(), x[i].begin() + static_cast<std::ptrdiff_t>(i - j), 0.0);
}

}  // namespace

Cholesky::Cholesky(Matrix a) : upper_(std::move(a)) {
    const std::size_t n = upper_.rows();
    if (upper_.columns() != n) throw std::invalid_argument("cholesky: the matrix must be square");
    Strip x(n);
    for (std::size_t j = 0; j < n; j += width) {
        const std::size_t end = std::min(j + width, n);
        for (std::size_t i = 0; i < end; ++i) std::copy(upper_.row(i) + j, upper_.row(i) + end, x[i].begin());
        substitute_forward(upper_, x, 0, j);
        for (std::size_t i = j; i < end; i += 2) {
            const bool two = i + 1 < end;
            eliminate(x, 0, i, i, two, {x[0].data() + (i - j), x[0].data() + (i - j) + 1, width});
            finish_row(x, i, j, upper_(i, i));
            if (!two) break;
            subtract(x[i][i + 1 - j], x[i], x[i + 1]);
            finish_row(x, i + 1, j, upper_(i + 1, i + 1));
        }
        for (std::size_t i = 0; i < end; ++i) std::copy_n(x[i].begin(), end - j, upper_.row(i) + j);
        for (std::size_t i = end; i < n; ++i) std::fill(upper_.row(i) + j, upper_.row(i) + end, 0.0);
    }
}
// END SOLUTION

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
// By symmetry the back substitution need only compute half of every row; but an inverse whose columns mix several
// solutions has residuals far above rounding where A is nearly singular.
Matrix Cholesky::inverse() const {
    const std::size_t n = size();
    Matrix inverse(n, n);
    Strip x(n);
    for (std::size_t j = 0; j < n; j += width) {
        const std::size_t w = std::min(width, n - j);
        std::fill(x.begin(), x.end(), Row{});
        for (std::size_t c = 0; c < w; ++c) x[j + c][c] = 1;
        substitute_forward(upper_, x, j, n);
        substitute_back(upper_, x);
        for (std::size_t i = 0; i < n; ++i) std::copy(x[i].begin(), x[i].begin() + w, inverse.row(i) + j);
    }
    return inverse;
}
// END SOLUTION

double Cholesky::log_determinant() const {
    double sum = 0;
    for (std::size_t k = 0; k < size(); ++k) sum += portable::log(upper_(k, k));
    return 2 * sum;
}
