#include "experiments/picture_cost.h"
#include "experiments/reports.h"
#include "test.h"

#include <map>

static Image even_picture(int size) {
    Image image(size, size);
    image.pixels.assign(image.pixels.size(), {1, 1, 1});
    return image;
}

// Half the error takes a quarter of the samples. At twice the seconds that is twice as efficient.
TEST_CASE("the table has Monte Carlo's samples for the same error, and the efficiency") {
    PictureRow first{"mc", "nothing", small_picture(Method::mc, 40)}, second = first;
    second.method = "mis", second.known = "light";
    first.seconds_per_megapixel = 3, second.seconds_per_megapixel = 6;
    for (int seed = 0; seed < 2; ++seed) first.rmse.add(0.2), second.rmse.add(0.1);
    CHECK(rows_of(picture_table({first, second}, true)) ==
          rows_of("mc 3 uniform nothing 40 0.20000 0.00000 0.0000 0.00000 40 3 1\n"
                  "mis 3 uniform light 40 0.10000 0.00000 0.0000 0.00000 160 6 2\n"));
}

// Of a method that paints all white, and counts its pictures by size, threads and seed.
struct Painted {
    std::map<std::tuple<int, std::size_t, std::uint64_t>, int> pictures;

    PictureRow row(RenderSettings settings, bool timed) {
        const PictureMethod method{"", "", settings, [this](const RenderSettings& s) {
                                       ++pictures[{s.width, s.threads, s.seed}];
                                       return [](const Hit&, int, int) { return Colour{1, 1, 1}; };
                                   }};
        return picture_row(method, even_picture(settings.width), timed);
    }
};

TEST_CASE("a picture is compared over 16 seeds, 64 where pixels share one rule, or 4 where these would take long") {
    const auto seeds = [](Method method, std::size_t samples, int size) {
        return Painted().row(small_picture(method, samples, size), false).rmse.squares.count;
    };
    CHECK(Numbers{seeds(Method::mc, 1, 128), seeds(Method::mc, 1, 129)} == Numbers{16, 4});
    CHECK(Numbers{seeds(Method::direct, 40, 4), seeds(Method::direct, 41, 4)} == Numbers{16, 4});
    CHECK(Numbers{seeds(Method::single, 1, 4), seeds(Method::pool, 1, 4)} == Numbers{64, 16});
}

// Pictures of 4 x 4 pixels are compared, each with a seed of its own; those of 1 and of 64 x 64 are timed.
TEST_CASE("times are of one processor, of the rules and of a picture") {
    Painted painted;
    RenderSettings settings = small_picture(Method::mc, 1, 4);
    settings.threads = 2, settings.seed = 7;
    painted.row(settings, true);
    CHECK(painted.pictures.size() == 16 + 2);
    CHECK(painted.pictures.count({4, 2, 8}) == 1);
    CHECK(painted.pictures.count({1, 1, 7}) == 1);
    CHECK(painted.pictures.count({64, 1, 7}) == 1);
}

TEST_CASE("a light that reaches nothing has no errors to compare") {
    CHECK_THROWS_AS(output_of(tradeoff_report, {"--size=6", "--environment=tests/output/black.hdr"}),
                    std::runtime_error);
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
    CHECK(Numbers{brighter.rmse, brighter.correlation, brighter.bias} == Numbers{0.125, 0, 0.25});  // a mean alone
    CHECK(error_of(0.25, 0.75, 0).correlation < -0.99);
    CHECK(error_of(0.25, 0.25, 0.5).correlation > 0.9);
}
