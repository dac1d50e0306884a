// A stream of pseudo-random numbers that is the same everywhere: SplitMix64 (Steele, Lea & Flood, "Fast splittable
// pseudorandom number generators", OOPSLA 2014). One seed has 2^64 streams, which begin at different places of one
// cycle of 2^64 numbers, so every pixel can have its own. Give each draw a statement of its own: C++ does not fix the
// order in which the arguments of a call are evaluated.
#pragma once

#include "base/portable_math.h"

namespace bmc {
class Random {
public:
    Random(std::uint64_t seed, std::uint64_t stream) : state_(mix(mix(seed + increment) + stream)) {}

    std::uint64_t bits() { return mix(state_ += increment); }

    // Uniform in [0, 1): a multiple of 2^-53.
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

private:
    static constexpr std::uint64_t increment = 0x9e3779b97f4a7c15;

    static constexpr std::uint64_t mix(std::uint64_t x) {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
        x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
        return x ^ (x >> 31);
    }

    std::uint64_t state_;
};
}  // namespace bmc
