#include "experiments/picture_error.h"

#include "test.h"

TEST_CASE("the error of an image: root mean square, neighbours' correlation and brightness") {
    const auto grey_of = [](double even, double odd) {
        return image_of(40, 40, [&](int x, int) { return (x % 2 ? odd : even) * Color{1, 1, 1}; });
    };
    const Image truth = grey_of(0.5, 0.5), brighter = grey_of(0.625, 0.625), striped = grey_of(0.25, 0.75);
    const Truth grey = truth_of(truth);
    const ImageError same = image_error(truth, grey);
    CHECK(same.rmse == 0);
    CHECK(same.correlation == 0);
    CHECK(same.brightness == 0);
    // These differences are exact in binary.
    const ImageError constant = image_error(brighter, grey);
    CHECK(constant.rmse == 0.125);
    CHECK(constant.correlation == 0);  // nothing is left when the mean is taken off
    CHECK(constant.brightness == 0.25);
    const ImageError alternating = image_error(striped, grey);
    CHECK(alternating.rmse == 0.25);
    CHECK(alternating.correlation == -1);
}

// A sun of 6 x 6 degrees: of the 200,000 directions 200 meet it.
TEST_CASE("the dense truth takes nothing from a table, under a sun, too: a picture by many directions agrees") {
    const EnvironmentMap map = map_of(64, 32, [](int column, int row) {
        return column == 50 && row == 10 ? Color{1000, 900, 800} : Color{0.25, 0.5, 0.75};
    });
    PictureSettings settings;
    settings.width = settings.height = 30;
    const Truth truth = dense_truth({map}, settings, 3000);
    settings.method = Method::mc;
    settings.placement = Placement::fibonacci;
    settings.samples = 200000;
    const ImageError error = image_error(render(sphere_scene(), map, settings), truth);
    CAPTURE(error.rmse);
    CAPTURE(error.brightness);
    CHECK(error.rmse < 0.03);
    CHECK(std::fabs(error.brightness) < 1e-3);
}

TEST_CASE("a picture of a sun's penumbra, with the light known, has the error that it predicts") {
    const EnvironmentMap map = map_of(64, 32, [](int column, int row) {
        return column == 50 && row == 10 ? Color{1000, 900, 800} : Color{0.25, 0.5, 0.75};
    });
    const EnvironmentLight light = prefilter(map);
    PictureSettings settings;
    settings.width = settings.height = 60;
    settings.known = Known::light;
    settings.placement = Placement::cosine_fibonacci;
    const Truth truth = dense_truth(light, settings, 3000);
    const Image one = picture(sphere_scene(), light, settings), two = picture(sphere_scene(), light, second(settings));
    const double predicted = root_mean_square(sphere_scene(), standard_errors(sphere_scene(), one, two));
    CHECK(relative(image_error(one, truth).rmse, predicted) < 0.2);
}

TEST_CASE("errors of at most two predicted ones lie within, colour by colour") {
    Image image(2, 1), predicted(2, 1);
    image.set(0, 0, {1, -2, 3});
    image.set(1, 0, {9, 9, 9});
    predicted.set(0, 0, {1, 1, 1});
    CHECK(coverage(image, {Image(2, 1), {true, false}}, predicted) == 2.0 / 3);
}
