#include "beyond/known_light.h"
#include "test.h"

using namespace bmc::beyond;

static std::vector<std::size_t> shared_out(const PrefilteredEnvironment& light, Vec3 normal, std::size_t samples) {
    const SampleCounts counts =
        share_out(light.sun, light.sky_irradiance(normal), light.sun_irradiance(normal), samples);
    return {counts.sky, counts.sun};
}

// Of two parts x and y with errors in proportion to 1 / n^(5/6), the sum of squares is least at shares like x^(3/4).
TEST_CASE("the shares of sky and sun are (E d)^(3/4), at least 1 sample each, and no sun where it has set") {
    const EnvironmentMap map = sunny_map(), even = even_map(2, 2, 1);
    const PrefilteredEnvironment sunny(map), dim(even);
    const Vec3 high = sunny.sun.ray(0.5, 0.5).direction, low = normalize(Vec3{-high.y, high.x, 0} + 0.1 * high);
    for (const Vec3& normal : {high, low})
        for (const std::size_t samples : {1u, 2u, 5u, 10u, 40u}) {
            INFO("samples: ", samples);
            const double deviation = 0.4 * std::pow(sunny.sun.spread(), 0.25),
                         ratio = deviation * brightness(sunny.sun_irradiance(normal)) /
                                 brightness(sunny.sky_irradiance(normal)),
                         part = std::pow(ratio, 0.75) / (1 + std::pow(ratio, 0.75));
            const auto rays = std::max<std::size_t>(1, std::size_t(std::lround(part * static_cast<double>(samples))));
            CHECK(shared_out(sunny, normal, samples) == std::vector{std::max(samples, rays + 1) - rays, rays});
        }
    CHECK(shared_out(sunny, low, 40)[1] < shared_out(sunny, high, 40)[1]);
    CHECK(shared_out(sunny, -1 * high, 40) == std::vector<std::size_t>{40, 0});
    CHECK(shared_out(dim, high, 40) == std::vector<std::size_t>{40, 0});
}

// Of three rays the sphere often stops all: under an even light in 2 % of the pixels.
TEST_CASE("no point is black under a light that comes from everywhere") {
    const EnvironmentMap map = even_map(2, 2, 1);
    const RenderSettings settings = small_picture(Method::mc, 3, 100, {PointSet::optimised, KnownPart::cosine});
    const Shader shader = light_shader({map, true, 1}, settings);
    double least = infinity;
    for_each_hit(sphere_scene, {100, 100},
                 [&](int x, int y, const Hit& hit) { least = std::min(least, shader(hit, x, y).y); });
    CHECK(least > 0.01);
}
