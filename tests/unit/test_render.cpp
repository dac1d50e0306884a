#include "scene/render.h"
#include "test.h"

TEST_CASE("a pixel shows the shade of what its ray meets, or the background interpolated") {
    const EnvironmentMap background = coloured_map(16, 9);
    RenderSettings settings = small_picture(Method::mc);
    settings.width = 14;
    const Shader shade = [](const Hit& hit, int x, int y) { return Color{x + 0.0, y + 0.0, hit.point.z}; };
    const Image image = render(test_scene(), background, settings, shade);
    REQUIRE(image.width == 14);
    REQUIRE(image.height == 12);
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 14; ++x) {
            const Ray ray = Camera{14, 12}.ray(x, y);
            const std::optional<Hit> hit = intersect(test_scene(), ray);
            INFO("x, y: ", x, ", ", y);
            CHECK(image(x, y) == (hit ? shade(*hit, x, y) : background.bilinear_radiance(ray.direction)));
        }
}

TEST_CASE("a shade is the light that a point reflects by its pixel's rule and frame") {
    const Scene scene = test_scene();
    const EnvironmentMap map = coloured_map(16, 9);
    for (const auto& row : named<Method>(method_names)) {
        const RenderSettings settings = small_picture(row.second, 7);
        const PixelRules rules(settings);
        const Shader shade = environment_shader(scene, map, rules);
        CAPTURE(row.first);
        for_each_hit(scene, {12, 12}, [&](int x, int y, const Hit& hit) {
            Random random = pixel_stream(settings, x, y);
            const OrientedRule oriented = rules.rule_for(hit.normal, random);
            CHECK(shade(hit, x, y) == reflected_radiance(scene, map, hit, *oriented.rule, oriented.frame));
        });
    }
}

TEST_CASE("threads change no byte of a picture") {
    const Scene scene = test_scene();
    const EnvironmentMap map = coloured_map(16, 9);
    RenderSettings settings = small_picture(Method::pool, 7);
    const PixelRules rules(settings);
    const Shader shade = environment_shader(scene, map, rules);
    const Image one = render(scene, map, settings, shade);
    settings.threads = 5;
    CHECK(first_difference(render(scene, map, settings, shade).pixels, one.pixels) == "");
}
