#include "numerics/cholesky_fast.h"

#include "numerics/cholesky.h"

#include <algorithm>

namespace bmc {
namespace {

// Elements k to n - 1 of a row less multiples of the same elements of `count` rows that follow each other, in the order
// of the plain loop.
template <std::size_t count>
void subtract(double* __restrict row, const double* factors, const double* rows, std::size_t k, std::size_t n) {
    double multiples[count];
    std::copy_n(factors, count, multiples);
    for (std::size_t j = k; j < n; ++j) {
        double element = row[j];
        for (std::size_t m = 0; m < count; ++m) element -= multiples[m] * rows[m * n + j];
        row[j] = element;
    }
}

}  // namespace

// The multiples u_ik, a column, are read from L, which is written below the diagonal: there they are a row.
void factor_fast(Matrix& u) {
    const std::size_t n = u.rows();
    for (std::size_t k = 0; k < n; ++k) {
        double* const row = u.row(k);
        const double a_kk = row[k];
        std::size_t i = 0;
        for (; i + 8 <= k; i += 8) subtract<8>(row, row + i, u.row(i), k, n);
        for (; i + 4 <= k; i += 4) subtract<4>(row, row + i, u.row(i), k, n);
        for (; i < k; ++i) subtract<1>(row, row + i, u.row(i), k, n);
        row[k] = root_of_pivot(k, row[k], a_kk);
        const double factor = 1 / row[k];
        for (std::size_t j = k + 1; j < n; ++j) u(j, k) = row[j] *= factor;
    }
}
}  // namespace bmc
