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

TEST_CASE("seeds and streams are told apart, neighbours too") {
    std::set<std::uint64_t> first;
    for (std::uint64_t seed = 0; seed < 30; ++seed)
        for (std::uint64_t stream = 0; stream < 30; ++stream) first.insert(Random(seed, stream).bits());
    CHECK(first.size() == 900);
    CHECK(Random(5, 6).bits() == Random(5, 6).bits());
}
