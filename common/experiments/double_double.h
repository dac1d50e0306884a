// Numbers of about 32 digits, each the unevaluated sum of two doubles (Dekker, "A floating-point technique for
// extending the available precision", Numerische Mathematik 18, 1971), for an experiment that asks how many of the 16
// digits of a double are right.
#pragma once

#include "numerics/portable_math.h"

// high + low, |low| at most half a unit in the last place of high. The error of an operation is a few 2^-104 of its
// result. Finite numbers only, and products below 1e300, since a factor is split after a multiplication by 2^27 + 1.
struct DoubleDouble {
    double high = 0, low = 0;

    DoubleDouble(double value = 0) : high(value) {}
    DoubleDouble(double its_high, double its_low) : high(its_high), low(its_low) {}
};

// a + b without error (Knuth, "The Art of Computer Programming", volume 2, section 4.2.2, theorem B).
inline DoubleDouble exact_sum(double a, double b) {
    const double sum = a + b, part = sum - a;
    return {sum, (a - (sum - part)) + (b - part)};
}

// a * b without error (Dekker 1971).
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

DoubleDouble operator/(DoubleDouble a, DoubleDouble b);

DoubleDouble sqrt(DoubleDouble x);                 // x >= 0
DoubleDouble exp(DoubleDouble x);                  // |x| < 600
DoubleDouble log(DoubleDouble x);                  // x > 0, |log x| < 600
DoubleDouble pow(DoubleDouble x, DoubleDouble y);  // x >= 0; 0 for x = 0
