#include "sharing/shared_light.h"

#include "prediction.h"

#include "test.h"

namespace {

const EnvironmentLight light = prefilter(desert);

PictureSettings shared(std::size_t samples, int size = 64, Method method = Method::mc) {
    PictureSettings settings = small(method, samples, size, Placement::cosine_fibonacci, Known::light);
    settings.shared = true;
    return settings;
}

Color grey(double level) { return {level, level, level}; }

// All pixels of a picture show one object, whose fractions are these.
template <class Fraction>
Views views_of(int width, int height, Fraction fraction) {
    Views views{width, height};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) views.at(x, y) = {Object::sphere, fraction(x, y)};
    return views;
}

double rmse_of(PictureSettings settings, const Truth& truth) {
    double squares = 0;
    for (settings.seed = 1; settings.seed <= 6; ++settings.seed)
        squares += std::pow(image_error(picture(sphere_scene(), light, settings), truth).rmse, 2) / 6;
    return std::sqrt(squares);
}

}  // namespace

TEST_CASE("a plane is kept, at borders and corners, too, and a shared fraction lies in [0, 1]") {
    for (const int height : {20, 450, 600}) {
        const Views views = views_of(20, height, [](int x, int y) {
            return Color{0.3 + 0.01 * x + 0.005 * y, 0.9 - 0.06 * x, 0.5};
        });
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < 20; ++x) {
                const Color plane = views.at(x, y).fraction, shared = views.shared_fraction(x, y);
                CHECK(std::fabs(shared.x - std::min(plane.x, 1.0)) < 1e-12);
                CHECK(std::fabs(shared.y - std::max(plane.y, 0.0)) < 1e-12);
                CHECK(std::fabs(shared.z - 0.5) < 1e-12);
            }
    }
}

TEST_CASE("windows have 5 x 5 pixels, 7 x 7 from 450 rows, 9 x 9 from 600") {
    for (const auto& [height, reach] : {std::pair(20, 2), {449, 2}, {450, 3}, {599, 3}, {600, 4}}) {
        Views views = views_of(21, height, [](int, int) { return grey(0); });
        views.at(10, 10).fraction = grey(1);
        int touched = 0;
        for (int x = 0; x < 21; ++x) touched += views.shared_fraction(x, 10).x > 0;
        CHECK(touched == 2 * reach + 1);
        // In a full window c is the mean.
        CHECK(std::fabs(views.shared_fraction(10, 10).x - 1.0 / ((2 * reach + 1) * (2 * reach + 1))) < 1e-15);
    }
}

TEST_CASE("pixels of another object, or of none, do not enter the plane") {
    Views views = views_of(9, 9, [](int, int) { return grey(0.25); });
    for (int y = 0; y < 9; ++y) {
        views.at(5, y) = {Object::rectangle, grey(1)};
        views.at(2, y) = {std::nullopt, grey(1)};
    }
    CHECK(std::fabs(views.shared_fraction(4, 4).x - 0.25) < 1e-15);
    CHECK(views.shared_fraction(5, 4).x == 1);  // pixels in one column fix no plane: its own
}

TEST_CASE("fewer than six pixels, or pixels in one row, keep their own fractions") {
    for (const auto& [width, height] : {std::pair(1, 1), {5, 1}, {40, 1}, {1, 450}, {2, 2}}) {
        const Views views = views_of(width, height, [](int x, int y) { return grey((x * 7 + y * 3) % 5 / 5.0); });
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) CHECK(views.shared_fraction(x, y).x == views.at(x, y).fraction.x);
    }
}

TEST_CASE("a shared picture has the same bytes by the textbook's loops, and others by another seed") {
    PictureSettings settings = shared(10, 40);
    const auto draw = [&] { return picture(sphere_scene(), light, settings); };
    CHECK(twins_agree(draw));
    const std::string one = to_pfm(draw());
    settings.seed = 2;
    CHECK(to_pfm(draw()) != one);
}

// Measured, N = 10: 0.0026 shared, 0.0148 alone; N = 40: 0.0013 and 0.0049. By weights of a process 0.0036 for N = 10.
TEST_CASE(
    "sharing leaves a fifth of the error, a quarter with 40 samples, equal weights less than those of a process") {
    const Truth truth = truth_of(dense_picture(desert, 64));
    const double rmse = rmse_of(shared(10), truth);
    CHECK(rmse < 0.0030);
    CHECK(rmse_of(shared(40), truth) < 0.0015);
    CHECK(rmse_of(shared(10, 64, Method::rotated), truth) > 1.2 * rmse);
    // Two pictures tell it, but for the plane's own error, which both have.
    const Image errors = standard_errors(sphere_scene(), picture(sphere_scene(), light, shared(10)),
                                         picture(sphere_scene(), light, second(shared(10))));
    const double told = root_mean_square(sphere_scene(), errors) / rmse;
    CHECK(told > 0.7);
    CHECK(told < 1.1);
}
