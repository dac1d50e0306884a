// Elementary functions that give the same bits on every machine, and the guards that keep them. Those of libm differ
// between libraries and even between processors running one binary. These use only + - * / sqrt, floor, powers of two
// and integers, which IEEE 754 defines to the last bit. Every program includes this header first, for its guards.
#pragma once

// Only a portability check defines this: it has to see that other arithmetic changes the output.
#ifndef UNGUARDED_ARITHMETIC

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "fast-math reorders sums and changes the output: compile without -ffast-math, -Ofast and their parts"
#endif

// A contracted a * b + c rounds once instead of twice. These lines are for whoever compiles without the Makefile, whose
// flags forbid contraction. They also forbid what clang reports by no macro: reordered sums, and reciprocals (no pragma
// before version 18).
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#pragma clang fp reassociate(off)
#if __clang_major__ >= 18
#pragma clang fp reciprocal(off)
#endif
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#endif

#endif  // UNGUARDED_ARITHMETIC

#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#ifndef UNGUARDED_ARITHMETIC
static_assert(FLT_EVAL_METHOD == 0,
              "double must be evaluated as double: on x86 take -mfpmath=sse (32 bits: -msse2, too)");
#endif

namespace bmc::portable {
inline constexpr double pi = 3.14159265358979323846;

// c[0] + c[1] x + c[2] x^2 + ... by Horner's rule.
template <std::size_t N>
inline double polynomial(const double (&c)[N], double x) {
    double sum = c[N - 1];
    for (std::size_t i = N - 1; i-- > 0;) sum = sum * x + c[i];
    return sum;
}

// The value of another type that has the same bits.
template <class To, class From>
To bit_cast(From from) {
    To to;
    std::memcpy(&to, &from, sizeof to);
    return to;
}

// e^x. Error at most 1 ulp (unit in the last place). exp(-inf) = 0, exp(inf) = inf, exp(nan) = nan; overflow gives inf,
// underflow goes through the subnormal numbers to 0.
double exp(double x);

// Natural logarithm. Error at most 1 ulp. log(0) = -inf, log(inf) = inf; log of a negative number or of nan is nan.
double log(double x);

// x^y = e^(y ln x) for x >= 0 (nan for x < 0). Error at most 1 + 3 |y ln x| ulp. pow(x, 0) = 1 and pow(1, y) = 1, even
// for nan; pow(0, y) is 0 or inf by the sign of y.
double pow(double x, double y);

// The unevaluated sum hi + lo of two doubles, which holds more digits than one.
struct Sum {
    double hi, lo;
};

// a + b without error, if a = 0 or the binary exponent of a is at least that of b (Dekker, "A floating-point technique
// for extending the available precision", Numerische Mathematik 18, 1971).
inline Sum fast_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, (a - sum) + b};
}

// Sine and cosine of an angle given in turns (1 turn = 2 pi radians), so that the reduction to an octant is exact.
// Error at most 1 ulp each, none at multiples of a quarter turn; an infinity or nan gives two nan.
struct SineCosine {
    double sine, cosine;
};
inline SineCosine sincos_turns(double turns) {
    // (sin x - x) / x^3 and (cos x - 1 + x^2/2) / x^4 as polynomials in x^2, cut off below 2^-62 for |x| <= pi/4.
    constexpr double sine_tail[] = {-1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
                                    -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
    constexpr double cosine_tail[] = {
        1.0 / 24,        -1.0 / 720,         1.0 / 40320,          -1.0 / 3628800,
        1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000, -1.0 / 6402373705728000};
    // 2 pi = two_pi_hi + two_pi_lo; two_pi_hi has 26 bits.
    constexpr double two_pi_hi = 0x1.921fb5p+2, two_pi_lo = 0x1.110b4611a6263p-24;
    // This is exact; for small negative numbers the subtraction would not be.
    const double fraction = std::fabs(turns) < 1 ? turns : turns - std::floor(turns);
    // Octants 2q - 1 and 2q belong to quadrant q. Rounding 4 * fraction instead would err beside the odd eighths.
    const int octant = fraction < 1 ? static_cast<int>(std::floor(8 * fraction)) + 8 : 8;  // nan goes on as t
    const int quadrant = (octant + 1) / 2 - 4;
    const double t = fraction - 0.25 * quadrant;
    // The 26 leading bits of t: a product is exact if the bits of its factors add up to 53 or less.
    const double t_hi = bit_cast<double>(bit_cast<std::uint64_t>(t) >> 27 << 27);
    const Sum x = fast_two_sum(t_hi * two_pi_hi, t_hi * two_pi_lo + (t - t_hi) * (two_pi_hi + two_pi_lo));
    const double square = x.hi * x.hi;
    const Sum parabola = fast_two_sum(1, -0.5 * square);
    const double sine = x.hi + (x.lo * parabola.hi + x.hi * square * polynomial(sine_tail, square));
    const double cosine =
        parabola.hi + (parabola.lo + (square * square * polynomial(cosine_tail, square) - x.hi * x.lo));
    // The sum of two angles: products with 0 and 1 are exact, and no branch depends on the angle.
    const double s = quadrant & 1 ? 2 - (quadrant & 3) : 0, c = quadrant & 1 ? 0 : 1 - (quadrant & 3);
    return {c * sine + s * cosine, c * cosine - s * sine};
}

// acos(y), without a branch, by Abramowitz & Stegun, Handbook of Mathematical Functions (1964),
// 4.4.46: acos(a) = sqrt(1 - a) P7(a) on [0, 1], and acos(-a) = pi - acos(a). Error at most 2.3e-8.
inline double arccosine(double y) {
    constexpr double c[] = {1.5707963050, -0.2145988016, 0.0889789874, -0.0501743046,
                            0.0308918810, -0.0170881256, 0.0066700901, -0.0012624911};
    const double a = std::fabs(y);
    const double from_pole = std::sqrt(a < 1 ? 1 - a : 0) * polynomial(c, a);
    return y < 0 ? pi - from_pole : from_pole;
}

// atan2(x, -z) by Abramowitz & Stegun 4.4.49, atan(t) = t P8(t^2) on [0, 1], and the symmetries of the octants.
// The smallest normal number in the denominator gives straight up and straight down the azimuth 0.
inline double azimuth(double x, double z) {
    constexpr double c[] = {1.0000000000,  -0.3333314528, 0.1999355085,  -0.1420889944, 0.1065626393,
                            -0.0752896400, 0.0429096138,  -0.0161657367, 0.0028662257};
    const double across = std::fabs(x), along = std::fabs(z);
    const double longer = across > along ? across : along;
    const double t = (across > along ? along : across) / (longer > DBL_MIN ? longer : DBL_MIN);
    const double octant = t * polynomial(c, t * t);
    const double quadrant = across > along ? pi / 2 - octant : octant;
    const double half = z > 0 ? pi - quadrant : quadrant;
    return x < 0 ? -half : half;
}
}  // namespace bmc::portable
