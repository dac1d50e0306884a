// A dense matrix of doubles, row-major: the elements of a row are neighbours in memory, so that an inner loop along a
// row vectorises.
#pragma once

#include "numerics/portable_math.h"

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

private:
    std::size_t rows_, columns_;
    std::vector<double> elements_;
};
}  // namespace bmc
