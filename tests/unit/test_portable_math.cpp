#include "numerics/portable_math.h"

#include "test.h"

using portable::bits_of;
using portable::from_bits;

namespace {

// Uniform over the bit patterns of the positive finite doubles: every binary exponent counts alike.
double any_positive(Random& random) { return from_bits(random.bits() % bits_of(infinity)); }

double between(double low, double high, Random& random) { return low + (high - low) * random.uniform(); }

#if LDBL_MANT_DIG >= 64
// The truth is libm's function in long double. With 64 bits of mantissa and an error of at most 1 ulp it is wrong by at
// most 2^-11 of double's ulp. Measured so, the worst errors are 0.75 (exp and pow, where the result is subnormal; 0.7
// elsewhere), 0.82 (log) and 0.80 (sincos; 0.93 when the tiniest angles are included).
using Truth = long double;

double error_in_ulp(double value, Truth truth) {
    if (truth == 0) return value == 0 ? 0 : infinity;
    truth = std::clamp(truth, -0x1p1024L, 0x1p1024L);
    const Truth found = value == infinity ? 0x1p1024L : static_cast<Truth>(value);
    const int exponent = std::clamp(std::ilogb(truth), -1022, 1023);
    return static_cast<double>(std::ldexp(std::fabs(found - truth), 52 - exponent));
}

double exp_error(double x) { return error_in_ulp(portable::exp(x), std::exp(static_cast<Truth>(x))); }
double log_error(double x) { return error_in_ulp(portable::log(x), std::log(static_cast<Truth>(x))); }

double pow_error(double x, double y) {
    return error_in_ulp(portable::pow(x, y), std::pow(static_cast<Truth>(x), static_cast<Truth>(y)));
}

// remquo is exact, and leaves an angle of at most pi/4.
double sincos_error(double turns) {
    int quadrant = 0;
    const Truth rest = std::remquo(static_cast<Truth>(turns), 0.25L, &quadrant);
    const Truth angle = 6.28318530717958647692528676655900577L * rest;
    const Truth sign = quadrant & 2 ? -1 : 1;
    const Truth sine = sign * (quadrant & 1 ? std::cos(angle) : std::sin(angle));
    const Truth cosine = sign * (quadrant & 1 ? -std::sin(angle) : std::cos(angle));
    const portable::SineCosine found = portable::sincos_turns(turns);
    return std::max(error_in_ulp(found.sine, sine), error_in_ulp(found.cosine, cosine));
}

template <class Error>
double worst_of(int count, Error error) {
    double worst = 0;
    for (int i = 0; i < count; ++i) worst = std::max(worst, error());
    return worst;
}

TEST_CASE("exp is within 1 ulp of e^x from the subnormals to the overflow") {
    Random random(1, 1);
    CHECK(worst_of(400000, [&] { return exp_error(between(-746, 710, random)); }) <= 1);
    CHECK(worst_of(400000, [&] { return exp_error(between(-2, 2, random)); }) <= 1);
    CHECK(worst_of(100000, [&] { return exp_error(between(-745.2, -708, random)); }) <= 1);
    CHECK(worst_of(100000, [&] { return exp_error(-any_positive(random)); }) <= 1);
}

TEST_CASE("log is within 1 ulp of ln x for every binary exponent and near 1") {
    Random random(1, 2);
    CHECK(worst_of(400000, [&] { return log_error(any_positive(random)); }) <= 1);
    CHECK(worst_of(400000, [&] { return log_error(between(0.5, 2, random)); }) <= 1);
    CHECK(worst_of(200000, [&] { return log_error(between(0.999, 1.001, random)); }) <= 1);
    CHECK(worst_of(100000, [&] { return log_error(0x1p-1022 * random.uniform()); }) <= 1);
}

TEST_CASE("pow is within 1 + 3 |y ln x| ulp of x^y over the whole range, for small powers and near 1") {
    Random random(1, 3);
    const auto error = [](double x, double y) { return pow_error(x, y) / (1 + 3 * std::fabs(y * std::log(x))); };
    // Of a base to the power that gives e^y for any y in the range.
    const auto worst = [&](int count, auto base) {
        return worst_of(count, [&] {
            const double x = base();
            const double y = between(-745, 710, random) / portable::log(x);
            return error(x, y);
        });
    };
    CHECK(worst(50000, [&] { return portable::exp(between(-690, 690, random)); }) <= 1);
    CHECK(worst(25000, [&] { return between(0.6, 1.8, random); }) <= 1);
    CHECK(worst(25000, [&] { return 1 + DBL_EPSILON * static_cast<double>(1 + random.bits() % 1000); }) <= 1);
    CHECK(worst_of(50000, [&] {
              const double x = 4 * random.uniform();
              const double y = random.uniform();
              return error(x, y);
          }) <= 1);
}

TEST_CASE("sincos_turns is within 1 ulp of sine and cosine, for small and for huge angles") {
    Random random(1, 4);
    CHECK(worst_of(500000, [&] { return sincos_error(between(-1, 1, random)); }) <= 1);
    CHECK(worst_of(200000, [&] { return sincos_error(between(-1e6, 1e6, random)); }) <= 1);
    CHECK(worst_of(200000, [&] { return sincos_error(0.125 + 1e-9 * random.uniform()); }) <= 1);
    CHECK(worst_of(200000, [&] { return sincos_error(any_positive(random)); }) <= 1);
    for (int eighth = -16; eighth <= 16; ++eighth)
        for (const double towards : {-infinity, infinity})
            CHECK(sincos_error(std::nextafter(0.125 * eighth, towards)) <= 1);
}
#endif

TEST_CASE("exp at 0, infinity, nan and the thresholds of overflow and underflow") {
    constexpr double last = 0x1.62e42fefa39efp+9;  // whose e^x is a double
    CHECK(portable::exp(last) < infinity);
    CHECK(std::isnan(portable::exp(nan_value)));
    for (const auto& [x, value] : {std::pair(0.0, 1.0),
                                   {0x1p-1074, 1},
                                   {infinity, infinity},
                                   {-infinity, 0},
                                   {std::nextafter(last, infinity), infinity},
                                   {-745.13, 0x1p-1074},
                                   {-745.14, 0}})
        CHECK(portable::exp(x) == value);
}

TEST_CASE("log at 0, 1, infinity, nan and negative numbers") {
    for (const auto& [x, value] : {std::pair(0.0, -infinity),
                                   {-0.0, -infinity},
                                   {1, 0},
                                   {infinity, infinity},
                                   {0x1p-1074, -0x1.74385446d71c3p+9},
                                   {DBL_MAX, 0x1.62e42fefa39efp+9}})
        CHECK(portable::log(x) == value);
    for (const double x : {nan_value, -1.0, -infinity}) CHECK(std::isnan(portable::log(x)));
}

TEST_CASE("pow at 0, 1, infinity, nan and negative numbers") {
    for (const double x : {0.0, 1.0, -1.0, 2.5, infinity, nan_value}) CHECK(portable::pow(x, 0) == 1);
    for (const double y : {0.0, -3.0, 1e300, infinity, nan_value}) CHECK(portable::pow(1, y) == 1);
    for (const auto& [x, y] : {std::pair(nan_value, 1.0), {2, nan_value}, {0, nan_value}, {-1, 2}})
        CHECK(std::isnan(portable::pow(x, y)));
    for (const double y : {0x1p-1074, 1.0, 1e300, infinity}) {
        CHECK(portable::pow(0, y) == 0);
        CHECK(portable::pow(0, -y) == infinity);
        CHECK(portable::pow(infinity, y) == infinity);
        CHECK(portable::pow(infinity, -y) == 0);
    }
    CHECK(portable::pow(0.5, -infinity) == infinity);
    CHECK(portable::pow(1 + DBL_EPSILON, 1e300) == infinity);
    CHECK(portable::pow(2, 1025) == infinity);
    CHECK(portable::pow(2, -1075.5) == 0);
    CHECK(portable::pow(3, 0x1p-1074) == 1);
}

TEST_CASE("sincos_turns is exact at quarter turns, even at huge ones") {
    const double sines[] = {0, 1, 0, -1};
    for (int quarter = -8; quarter <= 8; ++quarter)
        for (const double whole_turns : {0.0, 1e6, 0x1p50}) {
            const portable::SineCosine found = portable::sincos_turns(whole_turns + 0.25 * quarter);
            CHECK(found.sine == sines[quarter & 3]);
            CHECK(found.cosine == sines[(quarter + 1) & 3]);
        }
    for (const double turns : {0x1p52, 0x1p53 + 2, 1e300, -DBL_MAX}) {
        CHECK(portable::sincos_turns(turns).sine == 0);
        CHECK(portable::sincos_turns(turns).cosine == 1);
    }
    for (const double turns : {infinity, -infinity, nan_value}) {
        CHECK(std::isnan(portable::sincos_turns(turns).sine));
        CHECK(std::isnan(portable::sincos_turns(turns).cosine));
    }
}

// The references are the bits of x86-64, aarch64 and s390x, from g++ 12 and clang++ 14.
TEST_CASE("every function gives the recorded bits on this machine") {
    const auto hash_of = [](auto function) {
        Random random(2, 0);
        std::uint64_t hash = 0;
        for (int i = 0; i < 100000; ++i) {
            const double value = function(random);
            hash = (hash ^ bits_of(value)) * 0x100000001b3;
            hash ^= hash >> 29;
        }
        return hash;
    };
    CHECK(hash_of([](Random& random) { return portable::exp(between(-750, 715, random)); }) == 0xc841c77c3dfa829U);
    CHECK(hash_of([](Random& random) { return portable::log(any_positive(random)); }) == 0xcd188e2f017c3e45U);
    CHECK(hash_of([](Random& random) {
              const double x = any_positive(random);
              const double y = between(-3, 3, random);
              return portable::pow(x, y);
          }) == 0x34eee83d6b5ed955U);
    const auto sine = [](Random& random) { return portable::sincos_turns(between(-2, 2, random)).sine; };
    const auto cosine = [](Random& random) { return portable::sincos_turns(between(-2, 2, random)).cosine; };
    CHECK(hash_of(sine) == 0x39e8b4d97cf50daeU);
    CHECK(hash_of(cosine) == 0x782be0a0a4c49007U);
}

}  // namespace
