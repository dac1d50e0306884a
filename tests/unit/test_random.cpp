#include "numerics/random.h"

#include "test.h"

TEST_CASE("a stream is SplitMix64 from a state that mixes seed and stream") {
    const auto mix = [](std::uint64_t x) {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        return x ^ (x >> 31);
    };
    constexpr std::uint64_t step = 0x9e3779b97f4a7c15u;
    CHECK(mix(step) == 0xe220a8397b1dcdafu);  // the first output of Vigna's splitmix64.c for the state 0
    std::uint64_t state = mix(mix(7 + step) + 3);
    Random random(7, 3);
    for (int i = 0; i < 20; ++i) {
        CHECK(random.bits() == mix(state += step));
        CHECK(random.uniform() == static_cast<double>(mix(state += step) >> 11) / 9007199254740992);  // 2^53
    }
}
