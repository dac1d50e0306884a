// A dense matrix of doubles, row-major: the elements of a row are neighbours in memory, so that an inner loop along a
// row vectorises.
#pragma once

#include "base/portable_math.h"

#include <vector>

namespace bmc {
struct Matrix {
    std::size_t rows, columns;
    std::vector<double> elements;

    // An m x n matrix of zeros.
    Matrix(std::size_t m, std::size_t n) : rows(m), columns(n), elements(m * n) {}

    double& operator()(std::size_t i, std::size_t j) { return elements[i * columns + j]; }
    double operator()(std::size_t i, std::size_t j) const { return elements[i * columns + j]; }
};
}  // namespace bmc
