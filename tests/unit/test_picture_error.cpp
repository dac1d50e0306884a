#include "experiments/picture_error.h"
#include "test.h"

// These differences are exact in binary.
TEST_CASE("an image's error is its root mean square, its correlation and its brightness") {
    const auto error_of = [](double even, double odd, double step) {
        Image image(41, 40), truth(41, 40);  // the end of a row and the beginning of the next err in the same way
        for (int i = 0; i < 1640; ++i) {
            image(i % 41, i / 41) = ((i % 41 % 2 ? odd : even) + (i % 41 < 20 ? 0 : step)) * Color{1, 1, 1};
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

TEST_CASE("the dense truth agrees with a picture by many directions") {
    RenderSettings settings = small_picture(Method::mc, 100000, 10, Placement::fibonacci);
    settings.threads = 2;
    const EnvironmentMap map = coloured_map(16, 9);
    const ImageError error = image_error(picture(map, settings), reference_image(map, settings, 10000));
    CHECK(error.rmse < 0.01);
    CHECK(std::fabs(error.brightness) < 1e-3);
}
