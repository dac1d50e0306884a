#include "beyond/predicted_error.h"
#include "test.h"

using namespace bmc::beyond;

TEST_CASE("a pixel's predicted error is the root mean square in its object's window") {
    Image a(64, 64);
    for_each_hit(sphere_scene, {64, 64}, [&](int x, int y, const Hit& hit) {
        if (hit.object == Object::sphere) a(x, y) = {2, 0, x == 32 && y == 32 ? 7.0 : 0};
    });
    const Image errors = predicted_errors(a, Image(64, 64));
    for_each_hit(sphere_scene, {64, 64}, [&](int x, int y, const Hit& hit) {
        const bool on_sphere = hit.object == Object::sphere, near = std::max(std::abs(x - 32), std::abs(y - 32)) <= 3;
        INFO("x, y: ", x, ", ", y);
        CHECK(std::fabs(errors(x, y).x - (on_sphere ? 2 : 0)) < 1e-14);
        CHECK(std::fabs(errors(x, y).z - (on_sphere && near ? 1 : 0)) < 1e-14);
    });
    CHECK(errors(0, 0) == Vec3{0, 0, 0});
    CHECK(root_mean_square(Image(1, 1)) == 0);
}

// Against a dense picture, over 8 seeds; 12 % is what the error of the better picture may add.
TEST_CASE("a picture's predicted error is that which it has, with a sun and without, known and unknown") {
    for (const EnvironmentMap& map : {coloured_map(16, 9), sunny_map()})
        for (const bool known : {false, true}) {
            RenderSettings settings = small_picture(Method::pool, 20, 24);
            const EnvironmentLight light(map, known, 1);
            const Image truth = render(map, settings, sun_shader(map, small_picture(Method::mc, 4000, 24), 4000));
            RootMeanSquare predicted, actual;
            for (settings.seed = 1; settings.seed <= 8; ++settings.seed) {
                const Image image = render(map, settings, light_shader(light, settings));
                const Image better = render(map, settings, better_shader(light, settings));
                predicted.add(root_mean_square(predicted_errors(image, better)));
                actual.add(root_mean_square(predicted_errors(image, truth)));
            }
            CAPTURE(map.width);
            CAPTURE(known);
            CHECK(relative(predicted.value(), actual.value()) < 0.12);
        }
}

// In how many columns and rows of a picture the error of one pixel is seen.
static std::vector<int> window_around(int x, int y, int width, int height) {
    Image a(width, height);
    a(x, y) = {1, 1, 1};
    const Image errors = predicted_errors(a, Image(width, height));
    int across = 0, down = 0;
    for (int i = 0; i < width; ++i) across += errors(i, y).x > 0;
    for (int j = 0; j < height; ++j) down += errors(x, j).x > 0;
    return {across, down};
}

TEST_CASE("windows grow from 7 x 7 pixels to 15 x 15, and end at the borders of the picture") {
    for (const auto& [height, side] : {std::pair(40, 7), {279, 7}, {280, 9}, {490, 15}, {700, 15}})
        CHECK(window_around(15, height / 2, 30, height) == std::vector<int>{side, side});       // on the sphere
    for (const int x : {0, 59}) CHECK(window_around(x, 39, 60, 40) == std::vector<int>{4, 4});  // on the rectangle
}
