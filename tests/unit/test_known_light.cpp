#include "beyond/known_light/known_light.h"
#include "test.h"

using namespace bmc::beyond;

TEST_CASE("the sun has half of its share of the samples, the sky the rest, each at least 1") {
    const EnvironmentMap map = sunny_map(), even = even_map(2, 2, 1);
    const EnvironmentLight sunny(map, true, 1), dim(even, true, 1);
    for (const std::size_t samples : {1u, 2u, 5u, 10u, 40u}) {
        CAPTURE(samples);
        const double half = 0.5 * sunny.averages->sun().share() * static_cast<double>(samples);
        const std::size_t rays = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(half)));
        const RenderSettings settings = small_picture(Method::mc, samples);
        CHECK(sun_samples(*sunny.averages, samples) == rays);
        CHECK(rules_of(sunny, settings).settings().samples == std::max(samples, rays + 1) - rays);
        CHECK(sun_samples(*dim.averages, samples) == 0);
        CHECK(rules_of(dim, settings).settings().samples == samples);
    }
}

TEST_CASE("a colour is the irradiance times the visible fraction, of the sky and of the sun") {
    const Scene scene = test_scene();
    const EnvironmentMap map = sunny_map();
    const EnvironmentLight known(map, true, 1);
    const PrefilteredEnvironment& light = *known.averages;
    const std::size_t rays = sun_samples(light, 20);
    const RenderSettings settings = small_picture(Method::pool, 20, 12, Placement::cosine_fibonacci, Known::cosine);
    const PixelRules rules = rules_of(known, settings);
    const EnvironmentMap& means = light.means(2 * pi / static_cast<double>(20 - rays));
    const Shader shade = shader_of(scene, known, settings, rules);
    int partly = 0;
    for_each_hit(scene, {12, 12}, [&](int x, int y, const Hit& hit) {
        Random random = pixel_stream(rules.settings(), x, y);
        const OrientedRule oriented = rules.rule_for(hit.normal, random);
        RatioEstimator sky;
        for (std::size_t i = 0; i < oriented.rule->size(); ++i) {
            const Vec3 direction = oriented.frame.to_world(oriented.rule->directions[i]);
            sky.add(oriented.rule->weights[i] * means.radiance(direction), !is_shadowed(scene, hit, direction));
        }
        const Color sun = sample_sun(scene, light.sun(), hit, rays, random).fraction();
        const Color all = light.sky_irradiance(hit.normal) * sky.fraction() + light.sun_irradiance(hit.normal) * sun;
        CHECK(shade(hit, x, y) == 1 / pi * (hit.albedo * all));
        partly += sky.fraction().x < 1 && sky.fraction().x > 0;
    });
    CHECK(partly > 10);
}
