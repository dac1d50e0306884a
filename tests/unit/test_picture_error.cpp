#include "experiments/picture_error.h"

#include "test.h"

TEST_CASE("the error of an image: root mean square, neighbours' correlation and brightness") {
    const auto grey_of = [](double even, double odd) {
        return image_of(40, 40, [&](int x, int) { return (x % 2 ? odd : even) * Color{1, 1, 1}; });
    };
    const Image truth = grey_of(0.5, 0.5), brighter = grey_of(0.625, 0.625), striped = grey_of(0.25, 0.75);
    const Truth grey = truth_of(truth);
    CHECK(image_error(truth, grey).rmse == 0);
    // These differences are exact in binary.
    const ImageError constant = image_error(brighter, grey);
    CHECK(constant.rmse == 0.125);
    CHECK(constant.correlation == 0);  // nothing is left when the mean is taken off
    CHECK(constant.brightness == 0.25);
    const ImageError alternating = image_error(striped, grey);
    CHECK(alternating.rmse == 0.25);
    CHECK(alternating.correlation == -1);
}

// Of the 200,000 directions 200 meet the sun.
TEST_CASE("the dense truth agrees with a picture by many directions, also under a sun") {
    const PictureSettings settings = small(Method::mc, 200000, 20, Placement::fibonacci);
    const ImageError error = image_error(render(sphere_scene(), sunny, settings), dense_truth({sunny}, settings, 3000));
    CHECK(error.rmse < 0.01);
    CHECK(std::fabs(error.brightness) < 1e-3);
}

TEST_CASE("a picture of a sun's penumbra, with the light known, has the error that it predicts") {
    const EnvironmentLight light = prefilter(sunny);
    const PictureSettings settings = small(Method::pool, 40, 60, Placement::cosine_fibonacci, Known::light);
    const Truth truth = dense_truth(light, settings, 3000);
    const Image one = picture(sphere_scene(), light, settings), two = picture(sphere_scene(), light, second(settings));
    const double predicted = root_mean_square(sphere_scene(), standard_errors(sphere_scene(), one, two));
    CHECK(relative(image_error(one, truth).rmse, predicted) < 0.2);
}

TEST_CASE("coverage counts the errors of at most two predicted ones, colour by colour") {
    Image image(2, 1), predicted(2, 1);
    image.set(0, 0, {1, -2, 3});
    image.set(1, 0, {9, 9, 9});
    predicted.set(0, 0, {1, 1, 1});
    CHECK(coverage(image, {Image(2, 1), {true, false}}, predicted) == 2.0 / 3);
}
