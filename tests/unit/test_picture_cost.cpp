#include "experiments/picture_cost.h"
#include "test.h"

#include <set>

static Image even_picture(int size) {
    Image image(size, size);
    image.pixels.assign(image.pixels.size(), {1, 1, 1});
    return image;
}

// Half the error takes a quarter of the samples. At twice the seconds that is twice as efficient.
TEST_CASE("the table has Monte Carlo's samples for the same error, and the efficiency") {
    const RenderSettings mc = small_picture(Method::mc, 40), pool = small_picture(Method::pool, 40);
    PictureCost first{mc, "mc", {}, false, {}, {}, {}, 3}, second{pool, "mis", {}, true, {}, {}, {}, 6};
    for (int seed = 0; seed < 2; ++seed) first.rmse.add(0.2), second.rmse.add(0.1);
    CHECK(rows_of(picture_table({first, second}, true)) ==
          rows_of("mc 3 uniform nothing 40 0.20000 0.00000 0.0000 0.00000 40 3 1\n"
                  "mis 3 uniform light 40 0.10000 0.00000 0.0000 0.00000 160 6 2\n"));
}

TEST_CASE("a picture is compared over 16 seeds, 64 where pixels share one rule, or 4 where these would take long") {
    const EnvironmentMap map = coloured_map(16, 9);
    const auto seeds = [&](Method method, std::size_t pool, std::size_t samples, int size) {
        CostSettings costs;
        costs.size = size;
        costs.untimed = true;
        const PictureCost picture = compared_picture(map, method, pool, {});
        return measured_picture(picture, samples, costs, even_picture(size)).rmse.squares.count;
    };
    CHECK(Numbers{seeds(Method::mc, 1, 1, 128), seeds(Method::mc, 1, 1, 129)} == Numbers{16, 4});
    CHECK(Numbers{seeds(Method::direct, 1, 40, 4), seeds(Method::direct, 1, 41, 4)} == Numbers{16, 4});
    CHECK(Numbers{seeds(Method::single, 1, 1, 4), seeds(Method::pool, 3, 1, 4)} == Numbers{64, 16});
}

// Pictures of 4 x 4 pixels are compared; those of 1 and of 64 x 64 are timed.
TEST_CASE("times are of one processor, of the rules and of a picture") {
    const EnvironmentMap map = even_map(4, 3, 1);
    PictureCost picture = compared_picture(map, Method::mc, 1, {});
    picture.settings.threads = 2;
    std::set<std::pair<int, std::size_t>> timed;
    picture.image = [&](const RenderSettings& settings) {
        if (settings.width != 4) timed.emplace(settings.width, settings.threads);
        return even_picture(settings.width);
    };
    CostSettings costs;
    costs.size = 4;
    measured_picture(picture, 1, costs, even_picture(4));
    CHECK(timed == std::set<std::pair<int, std::size_t>>{{1, 1}, {64, 1}});
}

TEST_CASE("a light that reaches nothing has no errors to compare") {
    const EnvironmentMap map = coloured_map(16, 9);
    CHECK_THROWS_AS(measured_picture(compared_pictures(map)[0], 3, {}, Image(6, 6)), std::runtime_error);
}

// These differences are exact in binary.
TEST_CASE("an image's error is its root mean square, its correlation and its brightness") {
    const auto error_of = [](double even, double odd, double step) {
        Image image(41, 40), truth(41, 40);  // the end of a row and the beginning of the next err in the same way
        for (int i = 0; i < 1640; ++i) {
            image(i % 41, i / 41) = ((i % 41 % 2 ? odd : even) + (i % 41 < 20 ? 0 : step)) * Colour{1, 1, 1};
            truth(i % 41, i / 41) = {0.5, 0.5, 0.5};
        }
        return image_error(image, truth);
    };
    CHECK(error_of(0.5, 0.5, 0).rmse == 0);
    CHECK(error_of(0.25, 0.75, 0).rmse == 0.25);
    const ImageError brighter = error_of(0.625, 0.625, 0);
    CHECK(Numbers{brighter.rmse, brighter.correlation, brighter.brightness} ==
          Numbers{0.125, 0, 0.25});  // a mean alone
    CHECK(error_of(0.25, 0.75, 0).correlation < -0.99);
    CHECK(error_of(0.25, 0.25, 0.5).correlation > 0.9);
}
