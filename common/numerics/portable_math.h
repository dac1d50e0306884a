// Elementary functions that give the same bits on every machine, and the guards that keep them. libm's differ between
// libraries and even between processors running one binary; those here use + - * / floor, powers of two and integers
// only, which IEEE 754 defines to the last bit. Every program includes this header first, so that its guards hold.
#pragma once

// Only a portability check defines this: it has to see that other arithmetic changes the output.
#ifndef UNGUARDED_ARITHMETIC

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "fast-math reorders sums and changes the output: compile without -ffast-math, -Ofast and their parts"
#endif

// Compilers contract a * b + c to one fused operation where the processor has it, which rounds once instead of twice.
// These lines are for whoever compiles without the Makefile. (clang disregards them if the command line says
// -ffp-contract=fast.)
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#endif

#endif  // UNGUARDED_ARITHMETIC

#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <cstring>

#ifndef UNGUARDED_ARITHMETIC
static_assert(FLT_EVAL_METHOD == 0, "double must be evaluated as double: on 32-bit x86 use -msse2 -mfpmath=sse");
#endif

namespace bmc::portable {

constexpr double pi = 3.14159265358979323846;

// c[0] + c[1] x + c[2] x^2 + ... by Horner's rule, in the precision of x.
template <class Real, std::size_t N>
Real polynomial(const double (&c)[N], Real x) {
    Real sum = Real(c[N - 1]);
    for (std::size_t i = N - 1; i-- > 0;) sum = sum * x + Real(c[i]);
    return sum;
}

// The value of another type that has the same bits.
template <class To, class From>
To bit_cast(From from) {
    To to;
    std::memcpy(&to, &from, sizeof to);
    return to;
}
inline std::uint64_t bits_of(double x) { return bit_cast<std::uint64_t>(x); }
inline double from_bits(std::uint64_t bits) { return bit_cast<double>(bits); }

// e^x. Error at most 1 ulp (unit in the last place). exp(-inf) = 0, exp(inf) = inf, exp(nan) = nan; overflow gives inf,
// underflow goes through the subnormal numbers to 0.
double exp(double x);

// Natural logarithm. Error at most 1 ulp. log(0) = -inf, log(inf) = inf; log of a negative number or of nan is nan.
double log(double x);

// x^y = e^(y ln x) for x >= 0 (nan for x < 0). Error at most 1 + 3 |y ln x| ulp. pow(x, 0) = 1 and pow(1, y) = 1, even
// for nan; pow(0, y) is 0 or inf by the sign of y.
double pow(double x, double y);

// Sine and cosine of an angle given in turns (1 turn = 2 pi radians), so that the reduction to an octant is exact.
// Error at most 1 ulp each, none at multiples of a quarter turn; an infinity or nan gives two nan.
struct SineCosine {
    double sine, cosine;
};
SineCosine sincos_turns(double turns);

}  // namespace bmc::portable
