#include "numerics/random.h"

#include "test.h"

#include <set>

TEST_CASE("the generator is SplitMix64") {
    // State 0 gives the published first outputs of SplitMix64 with seed 0, so a stream that starts at state s gives
    // mix(s + increment): recompute that from the algorithm's text.
    Random random(7, 3);
    const auto mix = [](std::uint64_t x) {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        return x ^ (x >> 31);
    };
    CHECK(mix(0x9e3779b97f4a7c15u) == 0xe220a8397b1dcdafu);  // Vigna's splitmix64.c, seed 0, first output
    const std::uint64_t state = mix(mix(7 + 0x9e3779b97f4a7c15u) + 3);
    CHECK(random.bits() == mix(state + 0x9e3779b97f4a7c15u));
    CHECK(random.bits() == mix(state + 2 * 0x9e3779b97f4a7c15u));
    for (std::uint64_t i = 3; i < 40; ++i) {
        const std::uint64_t leading = mix(state + i * 0x9e3779b97f4a7c15u) >> 11;
        CHECK(random.uniform() == static_cast<double>(leading) / 9007199254740992);  // 53 bits over 2^53
    }
}

TEST_CASE("uniform numbers lie in [0, 1) with the moments of the uniform density") {
    constexpr int n = 1000000;
    Random random(1, 0);
    double sum = 0, sum_of_squares = 0;
    for (int i = 0; i < n; ++i) {
        const double u = random.uniform();
        REQUIRE((u >= 0 && u < 1));
        sum += u;
        sum_of_squares += u * u;
    }
    // 5 standard errors: var u = 1/12, var u^2 = 1/5 - 1/9 = 4/45.
    CHECK(std::fabs(sum / n - 1.0 / 2) < 5 * std::sqrt(1.0 / 12 / n));
    CHECK(std::fabs(sum_of_squares / n - 1.0 / 3) < 5 * std::sqrt(4.0 / 45 / n));
}

TEST_CASE("seeds and streams are told apart, neighbours too") {
    std::set<std::uint64_t> first;
    for (std::uint64_t seed = 0; seed < 30; ++seed)
        for (std::uint64_t stream = 0; stream < 30; ++stream) first.insert(Random(seed, stream).bits());
    CHECK(first.size() == 900);
    CHECK(Random(5, 6).bits() == Random(5, 6).bits());
}

TEST_CASE("neighbouring streams are uncorrelated") {
    constexpr int n = 100000;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const double here = Random(1, static_cast<std::uint64_t>(i)).uniform() - 0.5;
        const double next = Random(1, static_cast<std::uint64_t>(i) + 1).uniform() - 0.5;
        sum += here * next;
    }
    // Products of independent centred uniforms have variance 1/144; 5 standard errors.
    CHECK(std::fabs(sum / n) < 5 * std::sqrt(1.0 / 144 / n));
}
