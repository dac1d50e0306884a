#include "beyond/known_light.h"
#include "test.h"

using namespace bmc::beyond;

TEST_CASE("the sun has four fifths of its share of the samples, the sky the rest, each at least 1") {
    const EnvironmentMap map = sunny_map(), even = even_map(2, 2, 1);
    const EnvironmentLight sunny(map, true, 1), dim(even, true, 1);
    for (const std::size_t samples : {1u, 2u, 5u, 10u, 40u}) {
        const double part = 0.8 * sunny.averages->sun.share() * static_cast<double>(samples);
        const std::size_t rays = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(part)));
        const SampleCounts counts = share_out(sunny, samples), without_sun = share_out(dim, samples);
        CHECK(std::vector{counts.sun, counts.sky} == std::vector{rays, std::max(samples, rays + 1) - rays});
        CHECK(std::vector{without_sun.sun, without_sun.sky} == std::vector<std::size_t>{0, samples});
    }
}
