// How far off the weights of a Gaussian process are, beside weights that are right to the last digit of a double:
// covariances, z and residuals in double-double arithmetic, from the directions.
#pragma once

#include "experiments/models.h"
#include "numerics/cholesky.h"

#include <cmath>
#include <vector>

// About 32 digits: high + low, |low| at most half a unit in the last place of high (Dekker, "A floating-point technique
// for extending the available precision", Numerische Mathematik 18, 1971). The error of an operation is a few 2^-104 of
// its result. Finite numbers only, and products below 1e300, since a factor is split after a multiplication by 2^27.
struct DoubleDouble {
    double high, low;

    DoubleDouble(double its_high = 0, double its_low = 0) : high(its_high), low(its_low) {}
};

// a + b without error (Knuth, "The Art of Computer Programming", volume 2, section 4.2.2, theorem B).
inline DoubleDouble exact_sum(double a, double b) {
    const double sum = a + b, part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}

// a * b without error.
inline DoubleDouble exact_product(double a, double b) {
    constexpr double split = 134217729;  // 2^27 + 1: half the bits of a factor at a time
    const double a_high = split * a - (split * a - a), b_high = split * b - (split * b - b);
    const double a_low = a - a_high, b_low = b - b_high, product = a * b;
    return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

inline DoubleDouble operator+(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble high = exact_sum(a.high, b.high), low = exact_sum(a.low, b.low);
    const DoubleDouble sum = exact_sum(high.high, high.low + low.high);
    return exact_sum(sum.high, sum.low + low.low);
}

inline DoubleDouble operator-(DoubleDouble a) { return {-a.high, -a.low}; }
inline DoubleDouble operator-(DoubleDouble a, DoubleDouble b) { return a + -b; }

inline DoubleDouble operator*(DoubleDouble a, DoubleDouble b) {
    const DoubleDouble product = exact_product(a.high, b.high);
    return exact_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

// Long division, three digits of a double each.
inline DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - b * first;
    const double second = rest.high / b.high, third = (rest - b * second).high / b.high;
    return exact_sum(first, second) + third;
}

// Of x >= 0: a step of Newton's iteration from the root of the high part doubles its digits.
inline DoubleDouble sqrt(DoubleDouble x) {
    if (x.high == 0) return 0;
    const double root = std::sqrt(x.high);
    return exact_sum(root, (x - exact_product(root, root)).high / (2 * root));
}

// e^x = 2^k (e^(r / 256))^256 with |r| <= ln(2) / 2, by Taylor's series, whose 11th term is below 2^-130; |x| < 600.
inline DoubleDouble exp(DoubleDouble x) {
    const DoubleDouble ln2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};
    const double k = std::floor(x.high / ln2.high + 0.5);
    const DoubleDouble r = (x - ln2 * k) * 0x1p-8;
    DoubleDouble sum = 1;
    for (int n = 11; n >= 1; --n) sum = sum * r / n + 1;
    for (int squaring = 0; squaring < 8; ++squaring) sum = sum * sum;
    for (double n = std::fabs(k); n > 0; --n) sum = sum * (k > 0 ? 2.0 : 0.5);
    return sum;
}

// Of x > 0, |log x| < 600: a step of Newton's iteration for e^y = x from the logarithm of the high part.
inline DoubleDouble log(DoubleDouble x) {
    const DoubleDouble y = portable::log(x.high);
    return y + (x * exp(-y) - 1);
}

// Of x >= 0; 0 for x = 0.
inline DoubleDouble pow(DoubleDouble x, DoubleDouble y) { return x.high == 0 ? DoubleDouble(0) : exp(y * log(x)); }

class ExactWeights {
public:
    // n directions in the upper hemisphere. Holds 8 n^2 bytes.
    ExactWeights(const Model& model, const std::vector<Vec3>& directions);

    // The largest error of the weights, over the largest of the w with (Q + noise^2 I) w = z. The factor of that matrix
    // in doubles gives w: a solution corrected until it stands (Golub & Van Loan, "Matrix Computations", section
    // 3.5.3). Infinite if the corrections do not shrink: then the factor has no correct digit to correct with.
    double error_of(std::vector<double> weights, double noise, const Cholesky& cholesky) const;

private:
    std::vector<double> residual(const std::vector<double>& weights, double noise) const;

    std::vector<DoubleDouble> upper_;  // of Q without noise, row after row from the diagonal on
    std::vector<DoubleDouble> z_;
};
