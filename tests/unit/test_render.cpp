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
