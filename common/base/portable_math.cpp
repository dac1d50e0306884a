#include "base/portable_math.h"

namespace bmc::portable {
// ln 2 = ln2_hi + ln2_lo. ln2_hi has 32 bits, so that k * ln2_hi is exact for every binary exponent k.
constexpr double ln2_hi = 0x1.62e42feep-1;
constexpr double ln2_lo = 0x1.a39ef35793c76p-33;

// The unevaluated sum hi + lo of two doubles, which holds more digits than one.
struct Sum {
    double hi, lo;
};

// a + b without error, if a = 0 or the binary exponent of a is at least that of b (Dekker, "A floating-point technique
// for extending the available precision", Numerische Mathematik 18, 1971).
static Sum fast_two_sum(double a, double b) {
    const double sum = a + b;
    return {sum, (a - sum) + b};
}

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

SineCosine sincos_turns(double turns) {
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
    if (fraction != fraction) return {NAN, NAN};
    // Octants 2q - 1 and 2q belong to quadrant q. Rounding 4 * fraction instead would err beside the odd eighths.
    const int octant = static_cast<int>(std::floor(8 * fraction)) + 8;
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
    constexpr double sine_of_quadrants[] = {0, 1, 0, -1};
    const double s = sine_of_quadrants[quadrant & 3], c = sine_of_quadrants[(quadrant + 1) & 3];
    return {c * sine + s * cosine, c * cosine - s * sine};
}
}  // namespace bmc::portable
