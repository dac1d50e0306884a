#include "numerics/cholesky_fast.h"

#include "numerics/cholesky.h"

namespace bmc {
// Four rows at a time are subtracted from row k, in the order of the plain loop. Their multiples u_ik, a column, are
// read from L, which is written below the diagonal: there they are a row.
void factor_fast(Matrix& u) {
    const std::size_t n = u.rows();
    for (std::size_t k = 0; k < n; ++k) {
        double* __restrict const row = u.row(k);
        const double a_kk = row[k];
        std::size_t i = 0;
        for (; i + 4 <= k; i += 4) {
            const double a = row[i], b = row[i + 1], c = row[i + 2], d = row[i + 3];
            const double *const p = u.row(i), *const q = p + n, *const r = q + n, *const s = r + n;
            for (std::size_t j = k; j < n; ++j) row[j] = row[j] - a * p[j] - b * q[j] - c * r[j] - d * s[j];
        }
        for (; i < k; ++i)
            for (std::size_t j = k; j < n; ++j) row[j] -= row[i] * u(i, j);
        row[k] = root_of_pivot(k, row[k], a_kk);
        const double factor = 1 / row[k];
        for (std::size_t j = k + 1; j < n; ++j) u(j, k) = row[j] *= factor;
    }
}
}  // namespace bmc
