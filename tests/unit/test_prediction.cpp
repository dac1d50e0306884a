#include "beyond/prediction/prediction.h"
#include "test.h"

using namespace bmc::beyond;

// By the definition: half the mean square of the difference of a pair, over the pixels that show an object.
static double rmse_of_pair(const EnvironmentLight& light, const PictureSettings& settings) {
    const Image a = picture(light, settings), b = picture(light, with_next_seed(settings));
    double squares = 0, count = 0;
    for_each_hit(sphere_scene(), {a.width, a.height}, [&](int x, int y, const Hit&) {
        squares += squared_distance(a(x, y), b(x, y));
        count += 6;
    });
    return std::sqrt(squares / count);
}

TEST_CASE("a pixel's standard error is that of half the squares in its object's window") {
    Image a(64, 64), b(64, 64);
    for_each_hit(sphere_scene(), {64, 64}, [&](int x, int y, const Hit& hit) {
        if (hit.object == Object::sphere) a(x, y) = {2, 0, x == 32 && y == 32 ? 7.0 : 0};
    });
    const Image errors = standard_errors(a, b);
    double squares = 0, count = 0;
    for_each_hit(sphere_scene(), {64, 64}, [&](int x, int y, const Hit& hit) {
        const bool on_sphere = hit.object == Object::sphere, near = std::max(std::abs(x - 32), std::abs(y - 32)) <= 3;
        INFO("x, y: ", x, ", ", y);
        CHECK(std::fabs(errors(x, y).x - (on_sphere ? std::sqrt(2.0) : 0)) < 1e-15);
        CHECK(std::fabs(errors(x, y).z - (on_sphere && near ? std::sqrt(0.5) : 0)) < 1e-15);
        squares += dot(errors(x, y), errors(x, y));
        count += 3;
    });
    CHECK(errors(0, 0) == Vec3{0, 0, 0});
    CHECK(relative(root_mean_square(errors), std::sqrt(squares / count)) < 1e-12);
    CHECK(root_mean_square(Image(1, 1)) == 0);
}

TEST_CASE("windows grow from 7 x 7 pixels to 15 x 15") {
    for (const auto& [height, reach] : {std::pair(40, 3), {279, 3}, {280, 4}, {490, 7}, {700, 7}}) {
        Image a(30, height);
        a(15, height / 2) = {1, 1, 1};  // on the sphere
        const Image errors = standard_errors(a, Image(30, height));
        int across = 0, down = 0;
        for (int x = 0; x < 30; ++x) across += errors(x, height / 2).x > 0;
        for (int y = 0; y < height; ++y) down += errors(15, y).x > 0;
        const int side = 2 * reach + 1, rows = height;
        CAPTURE(rows);
        CHECK(across == side);
        CHECK(down == side);
    }
}

TEST_CASE("a pilot is a pair of a small picture, of a part of a large one, of 16 tiny ones") {
    const EnvironmentMap map = coloured_map(16, 9), black(1, 1);
    const EnvironmentLight light(map, false, 1);
    PictureSettings settings{small_picture(Method::rotated, 5, 60), false};
    CHECK(relative(pilot_rmse(light, settings), rmse_of_pair(light, settings)) < 1e-12);
    settings.width = settings.height = 130;
    const double pilot = pilot_rmse(light, settings), whole = rmse_of_pair(light, settings);
    CHECK(pilot != whole);
    CHECK(relative(pilot, whole) < 0.05);
    settings.width = settings.height = 3;
    double squares = 0;
    for (PictureSettings each = settings; each.seed < 33; each.seed += 2)
        squares += std::pow(rmse_of_pair(light, each), 2);
    CHECK(relative(pilot_rmse(light, settings), std::sqrt(squares / 16)) < 1e-12);
    CHECK(pilot_rmse({black, false, 1}, settings) == 0);
}

TEST_CASE("as many samples are chosen as have the RMSE that is asked for") {
    const EnvironmentMap map = coloured_map(64, 33);
    const EnvironmentLight light(map, false, 1);
    PictureSettings settings{small_picture(Method::single, 1, 24), false};
    settings.pool = 20;
    const ChosenSamples chosen = samples_for(1.5, 1000, light, settings);
    CHECK(chosen.rmse <= 1.5);
    settings.method = Method::pool;
    settings.pool = 4;
    CHECK(samples_for(1.5, 1000, light, settings).samples == chosen.samples);
    settings.samples = chosen.samples;
    double squares = 0;
    for (settings.seed = 100; settings.seed < 120; ++settings.seed)
        squares += std::pow(rmse_of_pair(light, settings), 2);
    CHECK(std::fabs(std::sqrt(squares / 20) / 1.5 - 1) < 0.15);
    CHECK(samples_for(1e9, 1000, light, settings).samples == 2);
    CHECK(message_of([&] { samples_for(1e-9, 6, light, settings); }) ==
          Containing{"an RMSE of 1e-09 is out of reach: 6 samples, the most tried, have one of "});
}
