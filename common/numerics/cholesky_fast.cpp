#include "numerics/cholesky_fast.h"

#include "numerics/cholesky.h"

#include <algorithm>

// Every element is computed by the plain text's operations in their order. What differs is when: tiles of a few rows
// and columns stay in registers, multiples are subtracted by blocks of rows that stay in the first cache, and the
// columns of a large matrix are copied to strips that stay in the second (Goto & van de Geijn, "Anatomy of
// high-performance matrix multiplication", ACM Transactions on Mathematical Software 2008).
namespace {

#ifdef __AVX__
constexpr std::size_t lanes = 4;  // columns that are worked on side by side
#else
constexpr std::size_t lanes = 2;
#endif
typedef double Lanes __attribute__((vector_size(lanes * sizeof(double)), aligned(sizeof(double)), may_alias));
constexpr std::size_t group = 6;           // rows of a tile, which is one or two times lanes wide
constexpr std::size_t block = 128;         // rows that are subtracted at a time
constexpr std::size_t widest_strip = 48;   // columns
constexpr std::size_t small_matrix = 160;  // rows; its factor needs no strips

// Rows that are subtracted: count of them, one every step numbers; and how often each is, from target row r:
// multiples[r * row], and so on every multiple_step numbers.
struct Sources {
    const double* multiples;
    std::size_t row;
    std::ptrdiff_t multiple_step;
    const double* first;
    std::ptrdiff_t step;
    std::size_t count;
};

// Rows that the sources are subtracted from.
struct Target {
    double* first;
    std::size_t stride;
};

template <std::size_t rows, std::size_t packs>
void subtract_tile(const Sources& sources, Target target, std::size_t column) {
    Lanes sum[rows][packs];
    double* const first = target.first + column;
    for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t p = 0; p < packs; ++p)
            sum[r][p] = *reinterpret_cast<const Lanes*>(first + r * target.stride + p * lanes);
    const double *multiple = sources.multiples, *source = sources.first + column;
    for (std::size_t k = 0; k < sources.count; ++k, multiple += sources.multiple_step, source += sources.step)
        for (std::size_t r = 0; r < rows; ++r)
            for (std::size_t p = 0; p < packs; ++p)
                sum[r][p] -= multiple[r * sources.row] * reinterpret_cast<const Lanes*>(source)[p];
    for (std::size_t r = 0; r < rows; ++r)
        for (std::size_t p = 0; p < packs; ++p)
            *reinterpret_cast<Lanes*>(first + r * target.stride + p * lanes) = sum[r][p];
}

// Whole packs of columns, the last of which ends at end: the first may begin a little before begin.
template <std::size_t rows>
void subtract_rows(const Sources& sources, Target target, std::size_t begin, std::size_t end) {
    while (end > begin) {
        const bool wide = end >= 2 * lanes && end - begin > lanes;
        end -= wide ? 2 * lanes : lanes;
        (wide ? subtract_tile<rows, 2> : subtract_tile<rows, 1>)(sources, target, end);
    }
}

void subtract(const Sources& sources, Target target, std::size_t rows, std::size_t begin, std::size_t end) {
    if (sources.count > 0) (rows == group ? subtract_rows<group> : subtract_rows<1>)(sources, target, begin, end);
}

std::size_t group_of(std::size_t rows_left) { return rows_left >= group ? group : 1; }

void scale(double* row, double factor, std::size_t begin, std::size_t end) {
    for (std::size_t j = begin; j < end; ++j) row[j] *= factor;
}

void factor_in_place(Matrix& a) {
    const std::size_t n = a.rows();
    const auto step = static_cast<std::ptrdiff_t>(n);
    double diagonal[group];
    for (std::size_t i = 0, rows; i < n; i += rows) {
        rows = group_of(n - i);
        for (std::size_t r = 0; r < rows; ++r) diagonal[r] = a(i + r, i + r);
        subtract({a.row(0) + i, 1, step, a.row(0), step, i}, {a.row(i), n}, rows, i, n);
        for (std::size_t k = i; k < i + rows; ++k) {
            for (std::size_t above = i; above < k; ++above) {
                const double multiple = a(above, k);
                for (std::size_t j = k; j < n; ++j) a(k, j) -= multiple * a(above, j);
            }
            const double root = root_of_pivot(k, a(k, k), diagonal[k - i]);
            scale(a.row(k), 1 / root, k + 1, n);
            a(k, k) = root;
        }
    }
}

// Some columns of a matrix, one row after the other.
struct Strip {
    std::size_t width;  // a multiple of lanes
    std::vector<double> elements;

    double* row(std::size_t i) { return elements.data() + i * width; }
};

// Room for the columns of an n x n matrix, in strips of about one width.
Strip strip_for(std::size_t n) {
    const std::size_t strips = (n + widest_strip - 1) / widest_strip, columns = (n + strips - 1) / strips;
    const std::size_t width = (columns + lanes - 1) / lanes * lanes;
    return {width, std::vector<double>(n * width)};
}

// From rows i, ... of the strip, the multiples u(i, k), ... of its rows k = first, first + step, ..., count of them.
void eliminate(Matrix& u, Strip& x, std::size_t i, std::size_t rows, std::size_t first, int step, std::size_t count,
               std::size_t begin = 0) {
    const Sources sources{
        u.row(i) + first, u.columns(), step, x.row(first), step * static_cast<std::ptrdiff_t>(x.width), count};
    subtract(sources, {x.row(i), x.width}, rows, begin, x.width);
}

// Y, where L Y = X, in place of X: the rows from begin to end; Y is 0 above them. finish(i) makes row i of Y of what is
// left of row i of X. u holds L below its diagonal. In rows from diagonal on only columns at and after the diagonal
// count.
template <class Finish>
void substitute_forward(Matrix& u, Strip& x, std::size_t begin, std::size_t end, std::size_t diagonal,
                        const Finish& finish) {
    const auto left = [&](std::size_t i) { return i > diagonal ? (i - diagonal) / lanes * lanes : 0; };
    for (std::size_t b = begin; b < end; b += block) {
        const std::size_t stop = std::min(b + block, end);
        for (std::size_t i = b, rows; i < stop; i += rows) {
            rows = group_of(stop - i);
            eliminate(u, x, i, rows, b, 1, i - b, left(i));
            for (std::size_t k = i; k < i + rows; ++k) {
                eliminate(u, x, k, 1, i, 1, k - i, left(i));
                finish(k);
            }
        }
        for (std::size_t i = stop, rows; i < end; i += rows) {
            rows = group_of(end - i);
            eliminate(u, x, i, rows, b, 1, stop - b, left(i));
        }
    }
}

// X, where U X = Y, in place of Y.
void substitute_back(Matrix& u, Strip& x) {
    for (std::size_t b = u.rows(), stop; b > 0; b = stop) {
        stop = b > block ? b - block : 0;
        for (std::size_t i = b, rows; i > stop;) {
            rows = group_of(i - stop);
            i -= rows;
            eliminate(u, x, i, rows, b - 1, -1, b - i - rows);
            for (std::size_t k = i + rows; k-- > i;) {
                eliminate(u, x, k, 1, i + rows - 1, -1, i + rows - 1 - k);
                scale(x.row(k), 1 / u(k, k), 0, x.width);
            }
        }
        for (std::size_t i = stop, rows; i > 0;) {
            rows = group_of(i);
            i -= rows;
            eliminate(u, x, i, rows, b - 1, -1, b - stop);
        }
    }
}

// While it is computed, the matrix holds L below its diagonal.
void factor_by_strips(Matrix& a) {
    const std::size_t n = a.rows();
    Strip x = strip_for(n);
    for (std::size_t j = 0; j < n; j += x.width) {
        const std::size_t end = std::min(j + x.width, n);
        for (std::size_t i = 0; i < end; ++i) std::copy(a.row(i) + j, a.row(i) + end, x.row(i));
        substitute_forward(a, x, 0, end, j, [&](std::size_t i) {
            double* row = x.row(i);
            const double root = i < j ? a(i, i) : root_of_pivot(i, row[i - j], a(i, i));
            scale(row, 1 / root, i < j ? 0 : i - j, x.width);
            if (i >= j) row[i - j] = root;
            for (std::size_t r = std::max(i + 1, j); r < end; ++r) a(r, i) = row[r - j];
        });
        for (std::size_t i = 0; i < end; ++i)
            for (std::size_t k = std::max(i, j); k < end; ++k) a(i, k) = x.row(i)[k - j];
    }
}

}  // namespace

void factor_fast(Matrix& a) { (a.rows() >= lanes && a.rows() <= small_matrix ? factor_in_place : factor_by_strips)(a); }

Matrix inverse_fast(const Matrix& upper) {
    const std::size_t n = upper.rows();
    Matrix u = upper, inverse(n, n);
    for (std::size_t b = 0; b < n; b += lanes)  // L below the diagonal, by blocks of columns that fill a cache line
        for (std::size_t i = b; i < n; ++i)
            for (std::size_t k = b; k < std::min(b + lanes, i); ++k) u(i, k) = upper(k, i);
    Strip x = strip_for(n);
    for (std::size_t j = 0; j < n; j += x.width) {
        const std::size_t end = std::min(j + x.width, n);
        std::fill(x.elements.begin(), x.elements.end(), 0.0);
        for (std::size_t c = j; c < end; ++c) x.row(c)[c - j] = 1;
        substitute_forward(u, x, j, n, n, [&](std::size_t i) { scale(x.row(i), 1 / u(i, i), 0, x.width); });
        substitute_back(u, x);
        for (std::size_t i = 0; i < n; ++i) std::copy_n(x.row(i), end - j, inverse.row(i) + j);
    }
    return inverse;
}
