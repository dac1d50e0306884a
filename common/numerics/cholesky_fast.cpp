#include "numerics/cholesky_fast.h"

#include "numerics/cholesky.h"

#include <algorithm>

namespace bmc {
namespace {

constexpr std::size_t strip = 64;  // columns that are worked on at a time, so that their rows stay in the cache

// The first `width` elements of a row less multiples[0], multiples[next], ... times those of count other rows, one
// every step elements, in this order. To read four rows at a time keeps the order.
void subtract(double* __restrict row, std::size_t width, std::size_t count, const double* multiples,
              std::ptrdiff_t next, const double* __restrict other, std::ptrdiff_t step) {
    for (; count >= 4; count -= 4, multiples += 4 * next, other += 4 * step) {
        const double a = multiples[0], b = multiples[next], c = multiples[2 * next], d = multiples[3 * next];
        for (std::size_t j = 0; j < width; ++j) {
            const double* element = other + j;
            row[j] = row[j] - a * element[0] - b * element[step] - c * element[2 * step] - d * element[3 * step];
        }
    }
    for (; count > 0; --count, multiples += next, other += step)
        for (std::size_t j = 0; j < width; ++j) row[j] -= multiples[0] * other[j];
}

}  // namespace

// Below its diagonal u gets L, whose rows are the multiples. A small matrix is one strip. The strips of a large one are
// computed in x: in u their rows lie so far apart, 32 KiB for n = 4096, that they compete for the same places of the
// cache.
void factor_fast(Matrix& u) {
    const std::size_t n = u.rows(), width = n > 2 * strip ? strip : n;
    Matrix x(width < n ? n : 0, width);
    double* const rows = width < n ? x.row(0) : u.row(0);
    for (std::size_t begin = 0; begin < n; begin += width) {
        const std::size_t end = std::min(begin + width, n);
        for (std::size_t k = 0; k < end; ++k) {
            const std::size_t first = std::max(k, begin);
            const double a_kk = u(k, k);
            double *const top = rows + first - begin, *const row = top + k * width;
            if (width < n) std::copy(u.row(k) + first, u.row(k) + end, row);
            subtract(row, end - first, k, u.row(k), 1, top, static_cast<std::ptrdiff_t>(width));
            if (k >= begin) u(k, k) = row[0] = root_of_pivot(k, row[0], a_kk);
            const double factor = 1 / u(k, k);
            for (std::size_t j = std::max(k + 1, begin); j < end; ++j) u(j, k) = u(k, j) = row[j - first] *= factor;
        }
    }
}

// Columns x of the inverse by a strip of unit vectors: L y = e, then U x = y.
Matrix inverse_fast(const Matrix& upper) {
    const std::size_t n = upper.rows();
    Matrix lower(n, n), inverse(n, n), x(n, strip);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < i; ++k) lower(i, k) = upper(k, i);
    constexpr auto step = static_cast<std::ptrdiff_t>(strip);
    for (std::size_t begin = 0; begin < n; begin += strip) {
        const std::size_t width = std::min(strip, n - begin);
        const auto divide = [&](std::size_t k) {
            const double factor = 1 / upper(k, k);
            for (std::size_t j = 0; j < width; ++j) x(k, j) *= factor;
        };
        for (std::size_t k = begin; k < n; ++k) {
            for (std::size_t j = 0; j < width; ++j) x(k, j) = k == begin + j;
            subtract(x.row(k), width, k - begin, lower.row(k) + begin, 1, x.row(begin), step);
            divide(k);
        }
        for (std::size_t k = 0; k < begin; ++k) std::fill_n(x.row(k), width, 0.0);
        for (std::size_t k = n; k-- > 0;) {
            subtract(x.row(k), width, n - 1 - k, upper.row(k) + n - 1, -1, x.row(n - 1), -step);
            divide(k);
            std::copy_n(x.row(k), width, inverse.row(k) + begin);
        }
    }
    return inverse;
}
}  // namespace bmc
