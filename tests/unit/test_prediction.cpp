#include "beyond/prediction/prediction.h"
#include "test.h"

using namespace bmc::beyond;

// By the definition: the root mean square of picture - better, over the pixels of a grid that show an object.
static double rmse_by_better(const EnvironmentLight& light, const RenderSettings& settings, int first, int step) {
    const Image a = render(light.environment, settings, light_shader(light, settings)),
                b = render(light.environment, settings, better_shader(light, settings));
    double squares = 0, count = 0;
    for_each_hit(sphere_scene, {a.width, a.height}, [&](int x, int y, const Hit&) {
        if (x % step != first || y % step != first) return;
        squares += squared_distance(a(x, y), b(x, y));
        count += 3;
    });
    return std::sqrt(squares / count);
}

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

TEST_CASE("a pilot is a small picture, every k-th pixel of a large one, or as many as asked") {
    const EnvironmentMap map = coloured_map(16, 9), black(1, 1);
    const EnvironmentLight light(map, false, 1);
    RenderSettings settings = small_picture(Method::rotated, 5, 60);
    CHECK(relative(pilot_rmse(light, settings, 0), rmse_by_better(light, settings, 0, 1)) < 1e-12);
    settings.width = settings.height = 256;
    const double half = rmse_by_better(light, settings, 1, 2), whole = rmse_by_better(light, settings, 0, 1);
    CHECK(relative(pilot_rmse(light, settings, 0), half) < 1e-12);
    double pixels = 0;  // of the half
    for_each_hit(sphere_scene, {256, 256}, [&](int x, int y, const Hit&) { pixels += x % 2 == 1 && y % 2 == 1; });
    CHECK(relative(pilot_rmse(light, settings, 5 * pixels), half) < 1e-12);
    CHECK(relative(pilot_rmse(light, settings, 5 * 15000), whole) < 1e-12);  // of 43,000 pixels with an object
    settings.threads = 2;
    CHECK(pilot_rmse(light, settings, 1e9) == pilot_rmse(light, settings, 5 * 15000));
    CHECK(pilot_rmse({black, false, 1}, settings, 0) == 0);
}

// Of two radiances, one with the probability p, the kurtosis is (1 - 3 p (1 - p)) / (p (1 - p)).
TEST_CASE("the kurtosis of a light is that of its radiance over all directions") {
    EnvironmentMap quarter(5, 2);  // four columns with a width, one row with a height
    quarter.set(1, 0, {0, 7, 0});
    CHECK(relative(kurtosis(quarter), 7.0 / 3) < 1e-12);
    CHECK(kurtosis(even_map(5, 2, 1)) == 1);
}

TEST_CASE("as many samples are chosen as have the RMSE that is asked for") {
    const EnvironmentMap map = coloured_map(64, 33);
    const EnvironmentLight light(map, false, 1);
    RenderSettings settings = small_picture(Method::direct, 1, 24);
    const Prediction chosen = samples_for(1.5, 1000, light, settings);
    settings.method = Method::pool;  // the pilots of direct have the usual pool
    settings.pool = RenderSettings().pool;
    CHECK(samples_for(1.5, 1000, light, settings).samples == chosen.samples);
    settings.samples = static_cast<std::size_t>(chosen.samples);
    CHECK(chosen.rmse == pilot_rmse(light, settings, 0));
    CHECK(chosen.rmse <= 1.5);
    CHECK(chosen.rmse > 1.2);
    CHECK(samples_for(1e9, 1000, light, settings).samples == 1);
    CHECK(samples_for(1e-9, 6, light, settings).samples > 1e6);
}

TEST_CASE("a pilot has the rays that meet all of a light, unless it is known") {
    EnvironmentMap lamp = even_map(64, 32, 1);
    for (int x = 20; x < 30; ++x) lamp.set(x, 8, {500, 500, 500});  // a kurtosis of 200
    RenderSettings settings = small_picture(Method::mc, 1, 256);
    for (const bool by_visibility : {false, true}) {
        CAPTURE(by_visibility);
        const EnvironmentLight light(lamp, by_visibility, 1);
        CHECK(samples_for(1e9, 4096, light, settings).rmse == pilot_rmse(light, settings, by_visibility ? 0 : 1e9));
        CHECK(pilot_rmse(light, settings, 0) != pilot_rmse(light, settings, 1e9));
    }
}
