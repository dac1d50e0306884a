// A dense matrix, and the Cholesky factorisation A = U^T U of a symmetric positive definite matrix into an upper
// triangular factor U (Golub & Van Loan, "Matrix Computations", section 4.2). Row m of U follows from the rows above
// it:
//     u_mm = sqrt(a_mm - sum over i < m of u_im^2),   u_mj = (a_mj - sum over i < m of u_im u_ij) / u_mm for j > m
// A x = b is then solved by two triangular systems: U^T g = b from the first row down, and U x = g from the last row
// up. For Bayesian weights A is Q, b is z and x is w.
#pragma once

#include "base/portable_math.h"

#include <stdexcept>
#include <vector>

namespace bmc {
// A dense matrix of doubles, row-major: the elements of a row are neighbours in memory, so that an inner loop along a
// row vectorises.
struct Matrix {
    std::size_t rows, columns;
    std::vector<double> elements;

    // An m x n matrix of zeros.
    Matrix(std::size_t m, std::size_t n) : rows(m), columns(n), elements(m * n) {}

    double& operator()(std::size_t i, std::size_t j) { return elements[i * columns + j]; }
    double operator()(std::size_t i, std::size_t j) const { return elements[i * columns + j]; }
};

// Thrown for a pivot that is not positive, or no larger than its rounding error (m + 1) eps a_mm (Higham, "Accuracy and
// Stability of Numerical Algorithms", 2002, section 10.1). The rows are then nearly dependent.
struct NotPositiveDefinite : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// u_mm: the square root of the pivot a_mm - sum over i < m of u_im^2, with the a_mm of the diagonal of A. Throws
// NotPositiveDefinite.
double root_of_pivot(const std::vector<double>& diagonal, std::size_t m, double pivot);

struct Cholesky {
    Matrix upper;  // U, n x n; zero below the diagonal

    // Factors the symmetric n x n matrix A. Throws std::logic_error if it is not square, and NotPositiveDefinite.
    explicit Cholesky(Matrix a);

    std::size_t size() const { return upper.rows; }

    // g with U^T g = b, so that |g|^2 = b^T A^-1 b. b has n elements.
    std::vector<double> forward_substitution(std::vector<double> b) const;

    // x with A x = b. b has n elements.
    std::vector<double> solve(std::vector<double> b) const;

    // A^-1, n x n: column j solves A x = e_j.
    Matrix inverse() const;
};
}  // namespace bmc
