#include "experiments/picture_cost.h"

#include "test.h"

TEST_CASE("a light that reaches no object is refused") {
    CHECK_THROWS_WITH_AS(picture_costs(even_map(1, 1, 0), compared_settings(), {10}, CostSettings()),
                         "the environment lights no object, so there is no error to compare; take another",
                         std::invalid_argument);
}

// Half the error takes a quarter of the samples. At twice the seconds that is twice as efficient.
TEST_CASE("the table tells the samples of Monte Carlo with the same error, and the efficiency relative to it") {
    const std::vector<PictureSettings> compared = compared_settings();
    const auto rows =
        rows_of(picture_table({{compared[0], 0.2, 0, 0, 0, 0, 0, 3}, {compared[5], 0.1, 0, 0, 0, 0, 0, 6}}, true));
    REQUIRE(rows.size() == 2);
    REQUIRE(rows[1].size() == 14);
    CHECK(rows[1][9] == "160");
    CHECK(rows[0][13] == "1");
    CHECK(rows[1][13] == "2");
}

TEST_CASE("progress grows to 1, other seeds make other errors, and measured times are positive") {
    CostSettings costs;
    costs.size = 4;
    double last = 0;
    const std::vector<PictureSettings> two{compared_settings()[0], compared_settings()[5]};
    const auto rows = picture_costs(white, two, {3, 5}, costs, [&](double done) {
        CHECK(done > last);
        last = done;
    });
    CHECK(last == 1);
    for (const PictureCost& row : rows) CHECK(row.seconds_per_megapixel > 0);
    costs.seed = 2;
    CHECK(picture_costs(white, two, {3, 5}, costs)[0].rmse != rows[0].rmse);
}
