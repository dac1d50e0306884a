#include "prediction/predicted_error.h"

#include "test.h"

namespace {

constexpr double rounding = 1e-5;  // directions have single precision, and Q a condition of some thousands

ModelledRule monte_carlo(std::vector<Vec3> directions) {
    return {{cosine_rule(monte_carlo_rule({Placement::uniform, std::move(directions)}))}, {}};
}

}  // namespace

TEST_CASE("Monte Carlo's error is the standard deviation of its samples over the root of their number") {
    const ModelledRule rule = monte_carlo({{0, 1, 0}, {0.8, 0.6, 0}, {0, 0.5, std::sqrt(0.75)}});
    const PixelError error = error_of_light(sphere_scene(), white, top, rule, upright, KnownPart::nothing);
    const double variance = (0.3 * 0.3 + 0.1 * 0.1 + 0.2 * 0.2) / 2;  // of the cosines 1, 0.6, 0.5
    CHECK(relative(error.squared_amplitude.x, 0.8 * 0.8 * 4 * variance) < rounding);
    CHECK(relative(error.squared_amplitude.z, 0.4 * 0.4 * 4 * variance) < rounding);
    CHECK(relative(error.unit_variance.y, 1.0 / 3) < rounding);
}

TEST_CASE("with nothing or the cosine known the error is the process's, times albedo / pi") {
    Random random(1, 0);
    const std::vector<Vec3> directions = uniform_directions(20, random);
    for (const KnownPart known : {KnownPart::nothing, KnownPart::cosine}) {
        const GaussianProcess process(Sobolev(), 0.01, directions, known);
        const ModelledRule rule{{cosine_rule({directions, process.weights(), known})}, process};
        std::vector<double> values;
        for (const Vec3 direction : directions) {
            const bool sees = !is_shadowed(sphere_scene(), beside, upright.to_world(Direction(direction)));
            values.push_back(!sees ? 0 : known == KnownPart::cosine ? 1 : direction.y);
        }
        REQUIRE(std::count(values.begin(), values.end(), 0) > 1);
        const double expected = 0.8 / pi * process.standard_error(values);
        const PixelError error = error_of_light(sphere_scene(), white, beside, rule, upright, known);
        CHECK(relative(std::sqrt(error.squared_amplitude.y * error.unit_variance.y), expected) < rounding);
    }
}

TEST_CASE("samples that agree tell no amplitude, and the picture's stands in for three samples more") {
    const Color error = standard_error({{0, 4, 0}, {0.5, 0.5, 0}, 10}, {13, 13, 13});
    CHECK(relative(error.x, std::sqrt(0.5 * 3)) < rounding);
    CHECK(relative(error.y, std::sqrt(0.5 * (40 + 39) / 13)) < rounding);
    CHECK(error.z == 0);
}

TEST_CASE("one sample of Monte Carlo says nothing of its error, and is refused") {
    CHECK_THROWS_AS(error_of_light(sphere_scene(), white, top, monte_carlo({{0, 1, 0}}), upright, KnownPart::nothing),
                    std::invalid_argument);
    RenderSettings settings;
    settings.samples = 1;
    CHECK(predicts_error(settings));
    settings.method = Method::mc;
    CHECK(!predicts_error(settings));
}

TEST_CASE("errors in grey: the root mean square of the colours, white as it is asked for") {
    Image errors(2, 1);
    errors.set(0, 0, {3, 6, 6});
    const Image grey = grey_scale(errors, std::sqrt(27.0));
    CHECK(std::fabs(grey(0, 0).x - 1) < 1e-6);
    CHECK(grey(0, 0).z == grey(0, 0).x);
    CHECK(grey(1, 0).y == 0);
    CHECK(grey_scale(Image(1, 1), 0)(0, 0).x == 0);
    CHECK(root_mean_square(errors, 1) == std::sqrt(27.0));
    CHECK(root_mean_square(errors, 0) == 0);
}
