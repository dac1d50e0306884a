#include "beyond/reports/picture_error.h"
#include "test.h"

// These differences are exact in binary.
TEST_CASE("the error of an image is its root mean square, the correlation of neighbours less the mean, brightness") {
    const auto error_of = [](double even, double odd, double step) {
        Image image(40, 40), truth(40, 40);
        for (int i = 0; i < 1600; ++i) {
            image(i % 40, i / 40) = ((i % 2 ? odd : even) + (i % 40 < 20 ? 0 : step)) * Color{1, 1, 1};
            truth(i % 40, i / 40) = {0.5, 0.5, 0.5};
        }
        return image_error(image, truth);
    };
    CHECK((error_of(0.5, 0.5, 0).rmse == 0 && error_of(0.25, 0.75, 0).rmse == 0.25));
    const ImageError brighter = error_of(0.625, 0.625, 0);
    CHECK(
        (brighter.rmse == 0.125 && brighter.correlation == 0 && brighter.brightness == 0.25));  // nothing but the mean
    CHECK((error_of(0.25, 0.75, 0).correlation < -0.99 && error_of(0.25, 0.25, 0.5).correlation > 0.9));
}

TEST_CASE("coverage counts the errors of at most two predicted ones, colour by colour") {
    Image image(40, 40), predicted(40, 40);
    for (Color& pixel : image.pixels) pixel = {1.98, -2.02, -1.98};
    for (Color& pixel : predicted.pixels) pixel = {1, 1, 1};
    CHECK(relative(coverage(image, Image(40, 40), predicted), 2.0 / 3) < 1e-15);
}

// Of the 200,000 directions 200 meet the sun.
TEST_CASE("the dense truth agrees with a picture by many directions, under a sun, too, and gives a lamp its own rays") {
    const Scene scene = sphere_scene();
    PictureSettings settings{small_picture(Method::mc, 200000, 10, Placement::fibonacci), false};
    settings.threads = 2;
    const EnvironmentMap map = sunny_map();
    const Image many = render(scene, map, settings, reflected_environment(scene, map, PixelRules(settings)));
    const ImageError error = image_error(many, dense_truth(map, settings, 3000));
    CHECK((error.rmse < 0.01 && std::fabs(error.brightness) < 2e-3));
    EnvironmentMap lamp = even_map(64, 32, 1);
    lamp.set(20, 8, {50, 50, 50});
    CHECK(image_error(dense_truth(lamp, settings, 1000), dense_truth(lamp, settings, 30000)).rmse < 0.003);
}
