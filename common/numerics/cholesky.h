// The Cholesky factorisation A = L L^T of a symmetric positive definite matrix (Golub & Van Loan, "Matrix
// Computations", section 4.2): solutions, the inverse and the determinant follow from it.
//
// The factor is kept as U = L^T, row by row. Every element is computed by the rule
//     u_kj = (a_kj - u_0k u_0j - u_1k u_1j - ... - u_(k-1)k u_(k-1)j) / u_kk,   terms subtracted in that order,
// with a loop over j innermost: neighbouring j are independent, so the compiler may compute them side by side and no
// sum is ever reordered. That is why the result has the same bits for any vector width. A solution subtracts its known
// elements in the order in which they become known: y_0, y_1, ... for L y = b, and x_(n-1), x_(n-2), ... for U x = y.
// Dividing by u_kk is multiplying by 1 / u_kk.
#pragma once

#include "numerics/matrix.h"

#include <stdexcept>
#include <string>
#include <vector>

namespace bmc {
// Thrown if a pivot is not positive or as small as its rounding error. The pivot of row k is a_kk less k squares, none
// of them larger than a_kk. So the rounding error of these k + 1 operations is at most (k + 1) eps a_kk (Higham,
// "Accuracy and Stability of Numerical Algorithms", 2002, section 10.1). The rule sees this row alone, not what the
// rows above have lost: a matrix that passes can still be singular to working precision. Its condition number shows
// that.
struct NotPositiveDefinite : std::runtime_error {
    NotPositiveDefinite(std::size_t pivot_index, double pivot_value, double least);

    std::size_t index;  // row of the pivot, from 0
    double value;
};

// u_kk: the root of the pivot of row k, where a_kk is the diagonal element of A. Throws NotPositiveDefinite.
double root_of_pivot(std::size_t k, double pivot, double a_kk);

class Cholesky {
public:
    // Factors the symmetric n x n matrix a, reading its upper triangle only.
    // Throws std::invalid_argument if a is not square, NotPositiveDefinite.
    explicit Cholesky(Matrix a);

    std::size_t size() const { return upper_.rows(); }

    // U = L^T: upper triangular, zero below the diagonal.
    const Matrix& upper() const { return upper_; }

    // y with L y = b: the first half of a solution; |y|^2 = b^T A^-1 b.
    std::vector<double> solve_lower(std::vector<double> b) const;

    // x with A x = b. b has n elements.
    std::vector<double> solve(std::vector<double> b) const;

    // A^-1, n x n: column j is what solve returns for e_j. Symmetry would give half of each column for free. But if A
    // is nearly singular, columns that mix several solutions have residuals far above rounding.
    Matrix inverse() const;

    // ln det A.
    double log_determinant() const;

private:
    Matrix upper_;
};
}  // namespace bmc
