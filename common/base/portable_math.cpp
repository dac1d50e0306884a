#include "base/portable_math.h"

namespace bmc::portable {
// ln 2 = ln2_hi + ln2_lo. ln2_hi has 32 bits, so that k * ln2_hi is exact for every binary exponent k.
constexpr double ln2_hi = 0x1.62e42feep-1;
constexpr double ln2_lo = 0x1.a39ef35793c76p-33;

// 2^k e^r with |r| <= ln(2) / 2. The series e^r = 1 + r + r^2 (1/2! + r/3! + ... + r^11/13!) is cut off below 2^-57;
// its even and odd powers are summed apart, side by side.
double exp(double x) {
    constexpr double even[] = {1.0 / 2, 1.0 / 24, 1.0 / 720, 1.0 / 40320, 1.0 / 3628800, 1.0 / 479001600};
    constexpr double odd[] = {1.0 / 6, 1.0 / 120, 1.0 / 5040, 1.0 / 362880, 1.0 / 39916800, 1.0 / 6227020800};
    constexpr double inverse_ln2 = 0x1.71547652b82fep+0;
    if (!(x < 710)) return x + INFINITY;  // nan stays nan
    if (x < -746) return 0;
    const double k = std::floor(x * inverse_ln2 + 0.5);
    const Sum r = fast_two_sum(x - k * ln2_hi, -k * ln2_lo);
    const double square = r.hi * r.hi;
    const double tail = square * (polynomial(even, square) + r.hi * polynomial(odd, square));
    const Sum linear = fast_two_sum(1, r.hi);
    return std::ldexp(linear.hi + (linear.lo + (r.lo * linear.hi + tail)), static_cast<int>(k));
}

double log(double x) {
    if (!(x > 0)) return x == 0 ? -INFINITY : NAN;
    if (x == INFINITY) return x;
    // With s = f / (2 + f), |s| <= 0.1716: ln(1 + f) = 2 artanh s = 2 s + s R, R = 2/3 s^2 + 2/5 s^4 + ... + 2/21 s^20,
    // cut off below 2^-60. Since 2 s = f - s f = f - f^2/2 + s f^2/2, the exact f bears most of the sum (fdlibm,
    // e_log.c, 1993).
    constexpr double even[] = {2.0 / 3, 2.0 / 7, 2.0 / 11, 2.0 / 15, 2.0 / 19};
    constexpr double odd[] = {2.0 / 5, 2.0 / 9, 2.0 / 13, 2.0 / 17, 2.0 / 21};
    int k;  // x = 2^k m with m from sqrt(1/2) to sqrt(2)
    double m = std::frexp(x, &k);
    if (m < 0x1.6a09e667f3bcdp-1) m *= 2, --k;
    const double f = m - 1, half_square = 0.5 * f * f;
    const double s = f / (2 + f), z = s * s, fourth = z * z;
    const double R = z * (polynomial(even, fourth) + z * polynomial(odd, fourth));
    return k * ln2_hi + (f - (half_square - (s * (half_square + R) + k * ln2_lo)));
}

double pow(double x, double y) { return x == 1 || y == 0 ? 1 : exp(y * log(x)); }
}  // namespace bmc::portable
