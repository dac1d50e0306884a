#include "experiments/statistics.h"
#include "known_light/known_light.h"

#include "test.h"

namespace {

// A light with its averages.
struct TestLight {
    const EnvironmentMap map;
    const EnvironmentLight light;
    const PrefilteredEnvironment& prefiltered;

    explicit TestLight(EnvironmentMap its_map)
        : map(std::move(its_map)), light(prefilter(map)), prefiltered(*light.prefiltered) {}
    operator EnvironmentLight() const { return light; }
};
const TestLight even_light(desert), bright_desert(load_environment("bright-desert")), white_light(white);
const TestLight* const lights[] = {&even_light, &bright_desert};

PictureSettings known_light(Method method, std::size_t samples = 40, int size = 40,
                            Placement placement = Placement::uniform) {
    return small(method, samples, size, placement, Known::light);
}

bool twins_render_alike(const PictureSettings& settings, const EnvironmentLight& light,
                        const Scene& scene = sphere_scene()) {
    return twins_agree([&] { return picture(scene, light, settings); });
}

// The pixels that are not what an object without shadows reflects.
int count_inexact(const Scene& scene, const Image& image, const PrefilteredEnvironment& light) {
    int wrong = 0;
    for_each_hit(scene, {image.width(), image.height()}, [&](int x, int y, const Hit& hit) {
        const Color all = light.irradiance(hit.normal), here = image(x, y);
        for (const auto& [value, irradiance] : {std::pair(here.x, all.x), {here.y, all.y}, {here.z, all.z}})
            wrong += std::fabs(value - 0.8 / pi * irradiance) > 1e-7 * irradiance;  // rounding to float
    });
    return wrong;
}

}  // namespace

TEST_CASE("the fast loops give the textbook's bytes where the light is known") {
    for (const TestLight* light : lights) {
        for (const Method method : all_methods)
            for (const auto& placement : placement_names) {
                INFO(placement.first);
                CHECK(twins_render_alike(known_light(method, 11, 15, placement.second), *light));
            }
        for (const std::size_t samples : {1u, 8u, 9u, 256u, 257u, 600u}) {
            PictureSettings settings = known_light(Method::pool, samples, 15);
            settings.pool = 1;
            CAPTURE(samples);
            CHECK(twins_render_alike(settings, *light));
        }
    }
    for (const auto& [width, height] : {std::pair(1, 1), {3, 5}, {64, 33}})
        CHECK(twins_render_alike(known_light(Method::rotated, 20), TestLight(striped_map(width, height)),
                                 sphere_below()));
}

TEST_CASE("a known light is rendered exactly by every method from one direction on, where nothing is in the way") {
    const TestLight one_texel(map_of(64, 32, [](int column, int row) {
        return column == 20 && row == 4 ? Color{1e4, 0, 0} : Color{};  // that few directions meet
    }));
    const Scene scene = sphere_alone();
    for (const TestLight* light : {&even_light, &one_texel})
        for (Method method : all_methods)
            for (const Placement placement : {Placement::uniform, Placement::cosine_fibonacci})
                for (const std::size_t samples : {1u, 7u, 520u}) {
                    if (samples == 520 && method == Method::direct) continue;  // takes a minute
                    const PictureSettings settings = known_light(method, samples, 20, placement);
                    CHECK(count_inexact(scene, picture(scene, *light, settings), light->prefiltered) == 0);
                }
}

TEST_CASE("where the light is known nothing is brighter than without shadows, and without light all is black") {
    const TestLight black(even_map(2, 2, 0));
    const Image bright = picture(sphere_scene(), bright_desert, known_light(Method::direct, 3));
    const Image dark = picture(sphere_scene(), black, known_light(Method::direct, 3));
    for_each_hit(sphere_scene(), {40, 40}, [&](int x, int y, const Hit& hit) {
        const Color all = bright_desert.prefiltered.irradiance(hit.normal);
        CHECK(bright(x, y).x >= 0);
        CHECK(bright(x, y).x <= hit.albedo.x / pi * all.x * (1 + 1e-7));
        CHECK(dark(x, y).x == 0);
    });
}

// By 30,000 directions the error of the truth is 0.02. One rule for all light leaves 0.16 and 0.31; with the cosine
// known the errors are 40 times as large.
TEST_CASE("a known sun has rays of its own: a fifth of the error that one rule for all light leaves") {
    const Image truth = dense_picture(bright_desert.map);
    for (const auto& [samples, most] : {std::pair(40u, 0.05), {10u, 0.08}}) {
        const PictureSettings settings = known_light(Method::pool, samples, 40, Placement::cosine_fibonacci);
        CHECK(error_of(picture(sphere_scene(), bright_desert, settings), truth).rmse < most);
    }
}

TEST_CASE("sun plus sky is the whole irradiance; a light without a sun has the sky's") {
    for (const TestLight* light : lights) {
        const PrefilteredEnvironment& prefiltered = light->prefiltered;
        const IrradianceMap whole(light->map);
        for (const Vec3 normal : {Vec3{0, 1, 0}, Vec3{0.8, 0.48, 0.36}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}}) {
            const Color sky = prefiltered.sky_irradiance(normal), sun = prefiltered.sun_irradiance(normal);
            // The table errs by 1.2e-3 where a sun is in it.
            CHECK(relative(prefiltered.irradiance(normal).x, whole(normal).x) < 2e-3);
            CHECK((sun.x == 0 || sun.x > sky.x / 10));
        }
        const bool has_sun = light == &bright_desert;
        CHECK(prefiltered.sun().empty() == !has_sun);
        CHECK(prefiltered.sun().share() == doctest::Approx(has_sun ? 0.83 : 0).epsilon(0.02));
        // Half of 0.83 of the samples, to the nearest number; the sky has the others, but one at least.
        for (const auto& [samples, of_sun] : {std::pair(1u, 1u), {4u, 2u}, {10u, 4u}}) {
            CHECK(sun_samples(prefiltered, samples) == (has_sun ? of_sun : 0));
            CHECK(sky_settings(known_light(Method::mc, samples), prefiltered).samples ==
                  (has_sun ? std::max(samples - of_sun, 1u) : samples));
        }
    }
}

// A texel at the pole, 22.5 degrees high and wide: its middle has the elevation cosine 0.981.
TEST_CASE("the sun's rays go anywhere in its texels, uniformly w.r.t. solid angle") {
    const EnvironmentMap map = map_of(17, 9, [](int column, int row) {
        return row == 0 && column == 12 ? Color{3, 2, 1} : Color{};
    });
    const Sun sun(map);
    CHECK(relative(sun.light(), 6 * 2 * pi / 16 * (1 - std::cos(pi / 8))) < 1e-12);
    CHECK(sun.share() == 1);
    // Their means, and their deviations: those of uniform numbers.
    Statistics height, azimuth;
    for (int i = 0; i < 100; ++i)
        for (int j = 0; j < 100; ++j) {
            const Sun::Ray ray = sun.ray((i + 0.5) / 100, (j + 0.5) / 100);
            REQUIRE(map.radiance(ray.direction).x == 3);
            CHECK(ray.colour.x == 0.5);
            height.add(ray.direction.y);
            azimuth.add(std::atan2(ray.direction.x, -ray.direction.z));
        }
    CHECK(std::fabs(height.mean - 0.5 * (1 + std::cos(pi / 8))) < 1e-12);
    CHECK(std::fabs(azimuth.mean - (12.5 / 8 - 1) * pi) < 1e-12);
    CHECK(relative(std::sqrt(height.squares / height.count), (1 - std::cos(pi / 8)) / std::sqrt(12)) < 1e-4);
    CHECK(relative(std::sqrt(azimuth.squares / azimuth.count), pi / 8 / std::sqrt(12)) < 1e-4);
}

TEST_CASE("a sun of far columns and rows keeps its order") {
    const EnvironmentMap map = map_of(8193, 5, [](int column, int row) {
        return row == 2 && (column == 10 || column == 4100) ? Color{1, 1, 1} : Color{};
    });
    const Sun sun(map);
    CHECK(map.grid().column_coordinate(sun.ray(0.25, 0.5).direction.x, sun.ray(0.25, 0.5).direction.z) < 11);
    CHECK(map.grid().column_coordinate(sun.ray(0.75, 0.5).direction.x, sun.ray(0.75, 0.5).direction.z) > 4099);
}

TEST_CASE("the sun does not shine from below the horizon") {
    // The normal is perpendicular to the middle of the sun; the rectangle above hides what is below the horizon.
    const Scene scene{{{0, -9, 0}, 1, {}}, {1, 5.0 / 3, 100, -100, 100, {}}};
    const Hit hit{Object::sphere, {0, 0, 0}, normalize({-0.48, 0.8, 0}), {1, 1, 1}};
    Random random(1, 0);
    CHECK(light_of_sun(scene, bright_desert.prefiltered.sun(), hit, 64, random).fraction().x == 1);
}

TEST_CASE("a known light and many directions tend to the same picture as a dense quadrature" *
          doctest::test_suite("long")) {
    const PictureSettings settings = known_light(Method::mc, 20000, 40, Placement::fibonacci);
    const ImageError error = error_of(picture(sphere_scene(), even_light, settings), dense_picture(desert));
    CHECK(error.rmse < 2e-4);                   // 0.7e-4 each, by a sum over all texels
    CHECK(std::fabs(error.brightness) < 4e-4);  // of E (test_irradiance_map.cpp)
}
