// A dense matrix of doubles, row-major: row i is contiguous, so that an inner loop along a row vectorises.
#pragma once

#include "numerics/portable_math.h"

#include <cstddef>
#include <vector>

namespace bmc {
class Matrix {
public:
    // A rows x columns matrix of zeros.
    Matrix(std::size_t rows, std::size_t columns) : rows_(rows), columns_(columns), elements_(rows * columns) {}

    std::size_t rows() const { return rows_; }
    std::size_t columns() const { return columns_; }

    double& operator()(std::size_t i, std::size_t j) { return elements_[i * columns_ + j]; }
    double operator()(std::size_t i, std::size_t j) const { return elements_[i * columns_ + j]; }

    double* row(std::size_t i) { return elements_.data() + i * columns_; }
    const double* row(std::size_t i) const { return elements_.data() + i * columns_; }

private:
    std::size_t rows_, columns_;
    std::vector<double> elements_;
};

// The symmetric matrix whose upper triangle is given.
inline Matrix symmetric(Matrix upper) {
    for (std::size_t i = 0; i < upper.rows(); ++i)
        for (std::size_t j = 0; j < i; ++j) upper(i, j) = upper(j, i);
    return upper;
}
}  // namespace bmc
