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

TEST_CASE("a window ends at the borders of the picture, and has 15 x 15 pixels from 490 rows on") {
    Image a(60, 490);
    a(30, 245) = a(0, 489) = {1, 1, 1};  // of the sphere, and of the rectangle
    const Image errors = predicted_errors(a, Image(60, 490));
    for (const int away : {0, 7, 8}) {
        CHECK((errors(30 + away, 245).x > 0) == (away < 8));
        CHECK((errors(away, 489 - away).x > 0) == (away < 8));
    }
}
