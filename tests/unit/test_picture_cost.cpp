#include "experiments/picture_cost.h"
#include "experiments/picture_error.h"
#include "experiments/statistics.h"
#include "scene/desert.h"

#include "test.h"

#include <cmath>
#include <stdexcept>

namespace {

CostSettings untimed(int size) {
    CostSettings costs;
    costs.size = size;
    costs.timed = false;
    return costs;
}

}  // namespace

TEST_CASE("what a picture costs: the practice's three steps against error correlated between pixels" *
          doctest::test_suite("long")) {
    const std::vector<PictureCost> rows = picture_costs(load_environment(), main_settings(), {10, 40}, untimed(32));
    CHECK(rows.size() == 2 * main_settings().size());
    const auto find = [&](Method method, std::size_t pool, std::size_t samples) {
        for (const PictureCost& row : rows)
            if (row.settings.method == method && row.settings.pool == pool && row.settings.samples == samples &&
                row.settings.placement == Placement::uniform && row.settings.known_part() == Known::nothing)
                return row;
        throw std::runtime_error("no such row");
    };
    CHECK(find(Method::single, 1, 10).correlation > 0.8);
    CHECK(std::fabs(find(Method::pool, 20, 40).correlation) < 0.05);
    const PictureCost mc = find(Method::mc, 1, 40);
    CHECK(find(Method::pool, 5, 40).rmse < 0.75 * mc.rmse);
    CHECK(find(Method::direct, 1, 40).rmse < 0.75 * mc.rmse);
    CHECK(mc.seconds_per_megapixel == 0);
    const PictureCost pool = find(Method::pool, 20, 40);
    CHECK(std::fabs(pool.predicted / pool.rmse - 1.1) < 0.2);
    CHECK(std::fabs(pool.coverage - 0.95) < 0.03);
    for (const PictureCost& row : rows) CHECK((row.predicted > 0) == predicts_error(row.settings));
    // One rule for all pixels: its errors differ from seed to seed by some 35 %, so those of 64 seeds by 4 %.
    const PictureCost single = find(Method::single, 1, 10);
    CHECK(single.rmse_error > 0.02 * single.rmse);
    CHECK(single.rmse_error < 0.1 * single.rmse);
    CHECK(single.brightness > 4 * find(Method::pool, 20, 10).brightness);
    // Monte Carlo's error falls as 1 / sqrt(n); 680 pixels, 16 seeds and 3 channels leave 1 %.
    CHECK(std::fabs(find(Method::mc, 1, 10).rmse / mc.rmse / 2 - 1) < 0.05);
}

TEST_CASE("a light that reaches no object is refused") {
    CHECK_THROWS_WITH_AS(picture_costs(EnvironmentMap(1, 1, {0, 0, 0}), main_settings(), {10}, untimed(2)),
                         "the environment lights no object, so there is no error to compare; take another",
                         std::invalid_argument);
}

TEST_CASE("a picture of more than 128 pixels a side has the errors of four seeds" * doctest::test_suite("long")) {
    const EnvironmentMap light = load_environment();
    PictureSettings settings = main_settings()[2];
    settings.width = settings.height = 129;
    settings.samples = 1;
    const Truth truth = dense_truth(prefilter(light), settings, 10000);
    RootMeanSquare expected;
    for (settings.seed = 1; settings.seed <= 4; ++settings.seed)
        expected.add(image_error(render(sphere_scene(), light, settings), truth).rmse);
    CHECK(picture_costs(light, {settings}, {1}, untimed(129))[0].rmse == expected.value());
}

TEST_CASE("progress grows to 1, other seeds make other errors, and measured times are positive") {
    const EnvironmentMap white(1, 1, {1, 1, 1});
    CostSettings costs;
    costs.size = 4;
    double last = 0;
    const auto rows = picture_costs(white, main_settings(), {3, 5}, costs, [&](double done) {
        CHECK(done > last);
        last = done;
    });
    CHECK(last == 1);
    for (const PictureCost& row : rows) CHECK(row.seconds_per_megapixel > 0);
    costs.seed = 2;
    CHECK(picture_costs(white, main_settings(), {3, 5}, costs)[0].rmse != rows[0].rmse);
}
