#include "linear_algebra/cholesky.h"
#include "quadrature/gaussian_process.h"
#include "test.h"

// |a b - c|, the largest sum of absolute values in a row: the norm that the maximum norm of vectors induces.
static double distance(const Matrix& a, const Matrix& b, const Matrix& c) {
    double largest = 0;
    for (std::size_t i = 0; i < a.rows; ++i) {
        double sum = 0;
        for (std::size_t j = 0; j < b.columns; ++j) {
            double element = -c(i, j);
            for (std::size_t k = 0; k < b.rows; ++k) element += a(i, k) * b(k, j);
            sum += std::fabs(element);
        }
        largest = std::max(largest, sum);
    }
    return largest;
}

// Of a condition of about n, and of 1e13 if n is 65.
static Matrix well_conditioned(std::size_t n) { return covariance_matrix(Sobolev(), 1, some_directions(n)); }
static Matrix nearly_singular(std::size_t n, std::uint64_t stream) {
    return covariance_matrix(SquaredExponential(1), 1e-6, some_directions(n, stream));
}

// The limits are those of LAPACK's tests, but for the inverse: a backward stable solution leaves a fraction of a
// rounding however nearly singular A is, here 0.06. An inverse whose columns mix several solutions, as when half of it
// is taken from symmetry, leaves 2.3.
TEST_CASE("U^T U = A, A x = b, A A^-1 = I and |y|^2 = b^T A^-1 b but for a few roundings") {
    std::vector<Matrix> matrices;
    for (const std::size_t n : {1u, 2u, 3u, 8u, 40u, 65u, 65u, 65u}) {
        matrices.push_back(well_conditioned(n));
        matrices.push_back(nearly_singular(n, matrices.size()));
    }
    for (const Matrix& a : matrices) {
        const std::size_t n = a.rows;
        const Cholesky cholesky(a);
        const Matrix inverse = cholesky.inverse(), zero(n, n);
        Matrix identity(n, n), lower(n, n), b(n, 1), x(n, 1);
        for (std::size_t i = 0; i < n; ++i) {
            identity(i, i) = 1;
            b(i, 0) = some_directions(n)[i].x;
            for (std::size_t j = 0; j < n; ++j) lower(j, i) = cholesky.upper(i, j);
            for (std::size_t j = 0; j < i; ++j) CHECK(cholesky.upper(i, j) == 0);
        }
        const std::vector<double> right(&b(0, 0), &b(0, 0) + n), solved = cholesky.solve(right),
                                                                 y = cholesky.forward_substitution(right);
        double x_norm = 0, form = 0;
        for (std::size_t i = 0; i < n; ++i) {
            x(i, 0) = solved[i];
            x_norm = std::max(x_norm, std::fabs(solved[i]));
            form += right[i] * solved[i] - y[i] * y[i];
        }
        const double rounding = DBL_EPSILON * distance(a, identity, zero),
                     most = 10 * static_cast<double>(n) * rounding;
        const double inverse_norm = distance(inverse, identity, zero);
        CHECK(distance(lower, cholesky.upper, a) < most);
        CHECK(distance(a, x, b) < most * x_norm);
        CHECK(std::fabs(form) <= most * x_norm * x_norm * static_cast<double>(n));
        CHECK(distance(a, inverse, identity) < (inverse_norm > 1e9 ? 0.5 : 3) * rounding * inverse_norm);
    }
}

TEST_CASE("a matrix that is not positive definite is refused, with its size and the pivot") {
    const auto refusal = [](const Matrix& a) { return message_of([&] { Cholesky{a}; }); };
    Matrix a(2, 2);
    a(0, 0) = 4;
    a(0, 1) = a(1, 0) = 2;
    a(1, 1) = 1;  // the second pivot is exactly 0
    CHECK(refusal(a) == Containing{"the matrix of 2 rows is not positive definite: pivot 2 is 0; with more noise"});
    a(1, 1) = 1 + 2 * DBL_EPSILON;  // a pivot of two roundings of its diagonal element
    CHECK_THROWS_AS(Cholesky{a}, NotPositiveDefinite);
    a(1, 1) = 1 + 3 * DBL_EPSILON;
    CHECK(refusal(a) == "");
    for (std::size_t k = 0; k < 9; ++k)
        for (const double element : {-1.0, nan_value}) {
            Matrix b = well_conditioned(9);
            b(k, k) = element;
            CHECK(refusal(b) == Containing{formatted("pivot %zu is", k + 1)});
        }
    for (const std::size_t rows : {2u, 4u}) CHECK_THROWS_AS(Cholesky(Matrix(rows, 3)), std::logic_error);
    CHECK_THROWS_AS(Cholesky(a).solve({1}), std::logic_error);
    CHECK_THROWS_AS(Cholesky(a).forward_substitution({1, 2, 3}), std::logic_error);
}
