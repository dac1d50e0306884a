#include "scene/desert.h"
#include "scene/predicted_error.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using portable::pi;

namespace {

const EnvironmentMap white(1, 1, {1, 1, 1});

// The top of the sphere sees all of the sky; a point of the rectangle right of the sphere sees a part of it.
const Hit top{Object::sphere, {0, 2, -5}, {0, 1, 0}, {0.8, 0.8, 0.4}};
const Hit beside{Object::rectangle, {1.5, -2, -4}, {0, 1, 0}, {0.2, 0.8, 0.2}};

std::vector<Vec3> some_directions(std::size_t n = 20) {
    Random random(1, 0);
    return uniform_directions(n, random);
}

PlacedRule placed(PixelRule rule) { return {std::make_shared<const PixelRule>(std::move(rule)), Frame({0, 1, 0})}; }

// With an even light over the caps, unless the light is not known.
PlacedRule process_rule(KnownPart known, std::vector<Vec3> directions, const LightTable* cap = nullptr) {
    GaussianProcess process(Sobolev(), 0.01, std::move(directions), known);
    const QuadratureRule rule{process.directions(), process.weights(), known};
    std::vector<const LightTable*> caps;
    if (cap) caps.assign(rule.weights.size(), cap);
    return placed({cosine_rule(rule), caps, std::move(process)});
}

// Whether the point of the rectangle sees the sky there.
bool sees(Vec3 direction) {
    return !is_shadowed(sphere_scene(), beside, Frame({0, 1, 0}).to_world(Direction(direction)));
}

double relative(double a, double b) { return std::fabs(a / b - 1); }

constexpr double rounding = 1e-5;  // directions have single precision, and Q a condition of some thousands

}  // namespace

TEST_CASE("Monte Carlo's error is the standard deviation of its samples over the root of their number") {
    const std::vector<Vec3> directions = {{0, 1, 0}, {0.8, 0.6, 0}, {0, 0.5, std::sqrt(0.75)}};
    const PlacedRule rule = placed({cosine_rule(monte_carlo_rule({Placement::uniform, directions})), {}, {}});
    const PixelError error = pixel_error(sphere_scene(), white, KnownPart::nothing, top, rule);
    const double variance = (0.3 * 0.3 + 0.1 * 0.1 + 0.2 * 0.2) / 2;  // of the cosines 1, 0.6, 0.5
    CHECK(relative(error.amplitude.x, 0.8 * 0.8 * 4 * variance) < rounding);
    CHECK(relative(error.amplitude.z, 0.4 * 0.4 * 4 * variance) < rounding);
    CHECK(relative(error.variance.y, 1.0 / 3) < rounding);
}

TEST_CASE("with nothing or the cosine known the error is the process's, times albedo / pi") {
    for (const KnownPart known : {KnownPart::nothing, KnownPart::cosine}) {
        const PlacedRule rule = process_rule(known, some_directions());
        std::vector<double> values;
        for (const Vec3 direction : some_directions())
            values.push_back(!sees(direction) ? 0 : known == KnownPart::cosine ? 1 : direction.y);
        REQUIRE(std::count(values.begin(), values.end(), 0) > 1);
        const double expected = 0.8 / pi * rule.rule->process->standard_error(values);
        const PixelError error = pixel_error(sphere_scene(), white, known, beside, rule);
        CHECK(relative(std::sqrt(error.amplitude.y * error.variance.y), expected) < rounding);
    }
}

TEST_CASE("an even light that is known leaves the error of the visibility's mean") {
    const float rgb[] = {1, 1, 1};
    const LightTable even{0.1, 1, 1, rgb};
    const PlacedRule rule = process_rule(KnownPart::cosine, some_directions(), &even);
    const PixelError error = pixel_error(sphere_scene(), white, KnownPart::light, beside, rule);
    CHECK(relative(error.variance.x, rule.rule->process->variance() / (pi * pi)) < rounding);
    std::vector<double> visible;
    double mean = 0;
    for (const Vec3 direction : some_directions()) {
        visible.push_back(sees(direction));
        mean += visible.back() / 20;
    }
    CHECK(mean > 0.5);
    CHECK(mean < 1);
    for (double& value : visible) value -= mean;
    const double amplitude = rule.rule->process->amplitude(visible) * std::sqrt(20.0 / 19);
    CHECK(relative(std::sqrt(error.amplitude.y), 0.8 * amplitude) < 1e-3);  // E = pi by a table
}

TEST_CASE("a sun in one sample's cap leaves the error of one sample") {
    const float rgb[] = {1, 1, 1}, sun_rgb[] = {1e6f, 1, 1};
    const LightTable even{0.1, 1, 1, rgb}, sun{0.1, 1, 1, sun_rgb};
    PlacedRule rule = process_rule(KnownPart::cosine, some_directions(), &even);
    PixelRule changed = *rule.rule;
    changed.caps[3] = &sun;
    const PixelError error = pixel_error(sphere_scene(), white, KnownPart::light, beside, placed(changed));
    double weights = 0, squares = 0;
    for (const auto& [direction, weight] : changed.rule) {
        weights += weight;
        squares += weight * weight;
    }
    CHECK(relative(error.variance.x / error.variance.y, weights * weights / squares) < 1e-3);
}

TEST_CASE("samples that agree tell no amplitude, and the picture's stands in for three samples more") {
    const PixelError none{{0, 4, 0}, {0.5, 0.5, 0}};
    const Color error = standard_error(none, {13, 13, 13}, 10);
    CHECK(relative(error.x, std::sqrt(0.5 * 3)) < rounding);
    CHECK(relative(error.y, std::sqrt(0.5 * (40 + 39) / 13)) < rounding);
    CHECK(error.z == 0);
    const float rgb[] = {1, 1, 1};
    const LightTable even{0.1, 1, 1, rgb};
    const PlacedRule rule = process_rule(KnownPart::cosine, some_directions(), &even);
    CHECK(pixel_error(sphere_scene(), white, KnownPart::light, top, rule).amplitude.x == 0);
}

TEST_CASE("one sample says nothing where a mean is unknown, and is refused") {
    const std::vector<Vec3> one = {{0, 1, 0}};
    const PlacedRule mc = placed({cosine_rule(monte_carlo_rule({Placement::uniform, one})), {}, {}});
    CHECK_THROWS_AS(pixel_error(sphere_scene(), white, KnownPart::nothing, top, mc), std::invalid_argument);
    const float rgb[] = {1, 1, 1};
    const LightTable even{0.1, 1, 1, rgb};
    const PlacedRule light = process_rule(KnownPart::cosine, one, &even);
    CHECK_THROWS_AS(pixel_error(sphere_scene(), white, KnownPart::light, top, light), std::invalid_argument);
    CHECK_NOTHROW(pixel_error(sphere_scene(), white, KnownPart::cosine, top, process_rule(KnownPart::cosine, one)));
}

// Over the points of a picture. The differences of neighbouring rays count an edge between two strata like one within:
// they predict 1.6 of the variance here, hence up to twice.
TEST_CASE("the variance that a known sun adds is about that of the fraction of its rays that arrive") {
    const EnvironmentMap environment = bright_desert();
    const Light light(environment);
    const Scene scene = sphere_scene();
    const Camera camera{40, 40};
    double predicted = 0, actual = 0;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            const std::optional<Hit> hit = intersect(scene, camera.ray(x, y));
            if (!hit) continue;
            Random random(1, static_cast<std::uint64_t>(40 * y + x));
            PlacedRule rule = process_rule(KnownPart::light, some_directions(), &light.averages().tables()[2]);
            rule.sun = {16, random};
            const Color scale = 1 / pi * (hit->albedo * light.averages().sun_irradiance(hit->normal));
            const Color found = visible_sun(scene, light.averages(), *hit, rule.sun).fraction;
            const Color right = visible_sun(scene, light.averages(), *hit, {2000, random}).fraction;
            const Color error = scale * (found - right);
            predicted += pixel_error(scene, light, KnownPart::light, *hit, rule).sun.x;
            actual += error.x * error.x;
        }
    CAPTURE(predicted / actual);
    CHECK(predicted > actual);
    CHECK(predicted < 2 * actual);
}
