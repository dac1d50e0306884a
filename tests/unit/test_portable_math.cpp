#include "base/portable_math.h"
#include "test.h"

#if LDBL_MANT_DIG >= 64
// The truth is libm's function in long double, which is wrong by at most 2^-11 of double's ulp.
static double error_in_ulp(double value, long double truth) {
    if (truth == 0) return value == 0 ? 0 : infinity;
    truth = std::clamp(truth, -0x1p1024L, 0x1p1024L);
    const long double found = value == infinity ? 0x1p1024L : static_cast<long double>(value);
    return static_cast<double>(std::ldexp(std::fabs(found - truth), 52 - std::clamp(std::ilogb(truth), -1022, 1023)));
}
static double exp_error(double x) { return error_in_ulp(portable::exp(x), std::exp(static_cast<long double>(x))); }
static double log_error(double x) { return error_in_ulp(portable::log(x), std::log(static_cast<long double>(x))); }

// remquo is exact, and leaves an angle of at most pi/4.
static double sincos_error(double turns) {
    int quadrant = 0;
    const long double rest = std::remquo(static_cast<long double>(turns), 0.25L, &quadrant);
    const long double angle = 6.28318530717958647692528676655900577L * rest, sign = quadrant & 2 ? -1 : 1;
    const long double sine = sign * (quadrant & 1 ? std::cos(angle) : std::sin(angle));
    const long double cosine = sign * (quadrant & 1 ? -std::sin(angle) : std::cos(angle));
    const portable::SineCosine found = portable::sincos_turns(turns);
    return std::max(error_in_ulp(found.sine, sine), error_in_ulp(found.cosine, cosine));
}

// Measured: 0.75 (exp and pow), 0.82 (log), 0.93 (sincos). x has every binary exponent alike.
TEST_CASE("exp, log and sincos_turns are off by at most 1 ulp, pow by 1 + 3 |y ln x|") {
    Random random(1, 1);
    const auto between = [&](double low, double high) { return low + (high - low) * random.uniform(); };
    for (int i = 0; i < 30000; ++i) {
        const double x = std::ldexp(1 + random.uniform(), static_cast<int>(random.bits() % 2098) - 1074);
        const double width = i % 3 == 0 ? 690 : i % 3 == 1 ? 0.5 : 1e-12, base = portable::exp(between(-width, width));
        const double power = between(-745, 710) / (base == 1 ? 1 : portable::log(base)),
                     size = std::fabs(power * std::log(base));
        const long double truth = std::pow(static_cast<long double>(base), static_cast<long double>(power));
        const double turns = std::nextafter(0.125 * (i % 33 - 16), i % 2 ? infinity : -infinity);
        CHECK(error_in_ulp(portable::pow(base, power), truth) <= 1 + 3 * size);
        for (const double each : {between(-746, 710), between(-2, 2), between(-745.2, -708)})
            CHECK_MESSAGE(exp_error(each) <= 1, each);
        for (const double each : {x, between(0.5, 2), 0x1p-1022 * random.uniform()})
            CHECK_MESSAGE(log_error(each) <= 1, each);
        for (const double each : {x, between(-1, 1), 1e6 * between(-1, 1), turns})
            CHECK_MESSAGE(sincos_error(each) <= 1, each);
    }
}
#endif

TEST_CASE("exp, log and pow at 0, 1, infinity, nan and the ends of their range") {
    using portable::exp, portable::log, portable::pow;
    constexpr double last = 0x1.62e42fefa39efp+9;  // the largest x whose e^x is a double
    CHECK(Numbers{exp(0), exp(infinity), exp(-infinity)} == Numbers{1, infinity, 0});
    CHECK(Numbers{exp(-745.13), exp(-745.14)} == Numbers{0x1p-1074, 0});
    CHECK(exp(last) < infinity);
    CHECK(exp(std::nextafter(last, infinity)) == infinity);
    CHECK(Numbers{log(0), log(-0.0), log(1), log(infinity), log(DBL_MAX)} ==
          Numbers{-infinity, -infinity, 0, infinity, last});
    CHECK(Numbers{pow(2, 1025), pow(2, -1075.5), pow(nan_value, 0), pow(1, nan_value)} == Numbers{infinity, 0, 1, 1});
    CHECK(Numbers{pow(0, 1e-300), pow(0, -1), pow(infinity, 2), pow(infinity, -2), pow(0.5, -infinity)} ==
          Numbers{0, infinity, infinity, 0, infinity});
    for (const double x : {exp(nan_value), log(nan_value), log(-1), log(-infinity), pow(nan_value, 1), pow(-1, 2)})
        CHECK(std::isnan(x));
}

TEST_CASE("sincos_turns is exact at quarter turns, and no number at infinity") {
    const double sines[] = {0, 1, 0, -1};
    for (int quarter = -8; quarter <= 8; ++quarter)
        for (const double whole_turns : {0.0, 1e6, 0x1p50}) {
            const auto [sine, cosine] = portable::sincos_turns(whole_turns + 0.25 * quarter);
            INFO("quarter, whole_turns: ", quarter, ", ", whole_turns);
            CHECK(sine == sines[quarter & 3]);
            CHECK(cosine == sines[(quarter + 1) & 3]);
        }
    for (const double turns : {infinity, -infinity, nan_value})
        CHECK_MESSAGE(std::isnan(portable::sincos_turns(turns).cosine), turns);
}

TEST_CASE("arccosine is acos to 2.3e-8, and azimuth is atan2(x, -z) to 2e-8") {
    using portable::arccosine, portable::azimuth;
    double worst = 0, worst_azimuth = 0;
    for (int i = -100000; i <= 100000; ++i) {
        const double t = i * 1e-5, scale = i % 2 ? 1 : 1e-300, x = scale * std::sin(pi * t),
                     z = -scale * std::cos(pi * t);
        worst = std::max(worst, std::fabs(arccosine(t) - std::acos(t)));
        worst_azimuth = std::max(worst_azimuth, std::fabs(azimuth(x, z) - std::atan2(x, -z)));
    }
    CHECK(worst <= 2.3e-8);
    CHECK(worst_azimuth <= 2e-8);
    CHECK(Numbers{arccosine(1 + 1e-15), arccosine(-1 - 1e-15)} == Numbers{0, pi});
    CHECK(Numbers{azimuth(0, -1), azimuth(1, 0), azimuth(-1, 0), azimuth(0, 1), azimuth(0, 0)} ==
          Numbers{0, pi / 2, -pi / 2, pi, 0});  // the last: straight up and down
}

// A coefficient that is off by 1e-10 moves few texels of a picture.
TEST_CASE("arccosine and azimuth have the bits of their coefficients") {
    CHECK(Numbers{portable::arccosine(0.5), portable::arccosine(-0.9), portable::azimuth(3, -2)} ==
          Numbers{0x1.0c1523439663bp+0, 0x1.586476294eb2bp+1, 0x1.f730bd67d612cp-1});
}
