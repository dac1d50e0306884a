#include "experiments/picture_cost.h"
#include "experiments/picture_error.h"
#include "test.h"

// Half the error takes a quarter of the samples. At twice the seconds that is twice as efficient.
TEST_CASE("the table has Monte Carlo's samples for the same error, and the efficiency") {
    const RenderSettings mc = small_picture(Method::mc, 40), pool = small_picture(Method::pool, 40);
    CHECK(rows_of(picture_table({{mc, "nothing", 0.2, 0, 0, 0, 3}, {pool, "light", 0.1, 0, 0, 0, 6}}, true, " cell",
                                {" 7", " 8"})) ==
          rows_of("mc 3 uniform nothing 40 0.20000 0.00000 0.0000 0.00000 40 7 3 1\n"
                  "pool 3 uniform light 40 0.10000 0.00000 0.0000 0.00000 160 8 6 2\n"));
}

TEST_CASE("errors are over seeds, in the order of settings and samples") {
    const EnvironmentMap map = coloured_map(16, 9);
    CostSettings costs;
    costs.size = 6;
    costs.timed = false;
    const std::vector<ComparedPicture> two{compared_pictures(map)[0], compared_pictures(map)[6]};
    const Image truth = reference_image(map, row_settings(costs, {}, 0), 10000);
    const std::vector<PictureCost> rows = picture_costs(two, {3, 5}, costs, truth);
    REQUIRE(rows.size() == 4);
    CHECK(rows[0].settings.method == Method::mc);
    CHECK(rows[1].settings.samples == 5);
    CHECK(rows[2].settings.samples == 3);
    costs.seed = 2;
    const PictureCost other = picture_costs(two, {3}, costs, truth)[0];
    CHECK(other.rmse != rows[0].rmse);
    CHECK(other.settings.seed == rows[0].settings.seed + 1000);
}

TEST_CASE("a light that reaches nothing has no errors to compare") {
    const EnvironmentMap map = coloured_map(16, 9);
    CHECK_THROWS_AS(picture_costs(compared_pictures(map), {3}, {}, Image(6, 6)), std::runtime_error);
}

TEST_CASE("every call takes time") {
    CHECK(time_call([] {}) > 0);
}
