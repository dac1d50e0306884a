#include "prediction.h"

#include "test.h"

namespace {

const Scene scene = sphere_scene();

// The predicted over the actual RMSE of twenty seeds, and the share of errors within two predicted ones.
struct Honesty {
    double ratio, covered;
};
Honesty honesty(const EnvironmentLight& light, PictureSettings settings, const Truth& truth) {
    double told = 0, actual = 0, covered = 0;
    Image before = picture(scene, light, settings);
    for (int i = 0; i < 20; ++i) {
        settings = second(settings);
        const Image image = picture(scene, light, settings), errors = standard_errors(scene, before, image);
        told += std::pow(root_mean_square(scene, errors), 2);
        actual += std::pow(image_error(image, truth).rmse, 2);
        covered += coverage(image, truth, errors) / 20;
        before = image;
    }
    return {std::sqrt(told / actual), covered};
}

const EnvironmentMap stripes = map_of(1024, 512, [](int column, int) { return column / 2 % 2 * Color{1, 1, 1}; });
const EnvironmentMap ring = map_of(1024, 512, [](int, int row) { return (row == 170 ? 8 : 0.1) * Color{1, 1, 1}; });

}  // namespace

// Measured: told over actual 0.95 to 1.01, 89 to 97 % within. Under the ring a lattice with 10 samples misses the
// bright row or not for all points of the rectangle alike: both pictures have that error, and less of it is told.
TEST_CASE("two pictures tell the error of every kind of picture, also under light finer than the samples") {
    for (const EnvironmentMap* map : {&desert, &stripes, &ring}) {
        const EnvironmentLight light = prefilter(*map, 2);
        const Truth truth = truth_of(dense_picture(*map));
        for (const auto& [method, placement, known] : {std::tuple(Method::mc, Placement::uniform, Known::nothing),
                                                       {Method::direct, Placement::uniform, Known::nothing},
                                                       {Method::mc, Placement::fibonacci, Known::nothing},
                                                       {Method::pool, Placement::cosine_fibonacci, Known::cosine},
                                                       {Method::pool, Placement::cosine_fibonacci, Known::light}}) {
            if (map == &ring && placement != Placement::uniform) continue;
            const Honesty told = honesty(light, small(method, 10, 40, placement, known), truth);
            INFO(told.ratio, " ", told.covered);
            CHECK(told.ratio > 0.85);
            CHECK(told.ratio < 1.2);
            CHECK(told.covered > 0.85);
            CHECK(told.covered < 0.99);
        }
    }
}

TEST_CASE("the standard error of a pixel is the root of half the mean square over a window of its own object") {
    const int size = 64;
    Image a(size, size), b(size, size);
    for_each_hit(scene, {size, size}, [&](int x, int y, const Hit& hit) {
        if (hit.object == Object::sphere) a.set(x, y, {2, 0, x == 32 && y == 32 ? 7.0 : 0});
    });
    const Image errors = standard_errors(scene, a, b);
    for_each_hit(scene, {size, size}, [&](int x, int y, const Hit& hit) {
        const bool on_sphere = hit.object == Object::sphere, near = std::max(std::abs(x - 32), std::abs(y - 32)) <= 3;
        CHECK(std::fabs(errors(x, y).x - (on_sphere ? std::sqrt(2.0) : 0)) < 1e-6);
        CHECK(std::fabs(errors(x, y).z - (on_sphere && near ? std::sqrt(0.5) : 0)) < 1e-6);
    });
    CHECK(errors(0, 0).x == 0);
}

TEST_CASE("windows grow from 7 x 7 pixels to 15 x 15") {
    for (const auto& [height, reach] : {std::pair(40, 3), {279, 3}, {280, 4}, {490, 7}, {700, 7}}) {
        Image a(30, height), b(30, height);
        a.set(15, height / 2, {1, 1, 1});  // on the sphere
        int touched = 0;
        const Image errors = standard_errors(scene, a, b);
        for (int x = 0; x < 30; ++x) touched += errors(x, height / 2).x > 0;
        CHECK(touched == 2 * reach + 1);
    }
}

TEST_CASE("a picture without an object, or of one pixel, or of one sample, has a predicted error") {
    Scene nothing = sphere_alone();
    nothing.sphere.radius = 0;
    CHECK(root_mean_square(nothing, Image(5, 5)) == 0);
    CHECK(standard_errors(nothing, Image(5, 5), Image(5, 5))(2, 2).x == 0);
    CHECK(pilot_rmse(nothing, {desert}, small(Method::pool, 10)) == 0);
    CHECK(pilot_rmse(scene, {desert}, small(Method::mc, 40, 1)) > 0);
    CHECK(pilot_rmse(scene, {desert}, small(Method::mc, 1)) > 0.1);
}

TEST_CASE("a pilot renders all of a small picture, every k-th pixel of a large one") {
    PictureSettings settings = small(Method::pool, 20, 60);
    const auto whole = [&] {
        const Image a = picture(scene, {desert}, settings), b = picture(scene, {desert}, second(settings));
        double squares = 0, count = 0;
        for_each_hit(scene, {settings.width, settings.height}, [&](int x, int y, const Hit&) {
            squares += dot(a(x, y) - b(x, y), a(x, y) - b(x, y));
            count += 6;
        });
        return std::sqrt(squares / count);
    };
    CHECK(relative(pilot_rmse(scene, {desert}, settings), whole()) < 1e-6);  // floats in the picture
    settings.width = settings.height = 200;
    const double pilot = pilot_rmse(scene, {desert}, settings), large = whole();
    CHECK(pilot != large);
    CHECK(relative(pilot, large) < 0.05);
}

// Where few pixels show an object, a pilot has more pairs: one pair of a picture of 5 x 5 pixels is 25 % off.
TEST_CASE("the pilot of a picture of few pixels tells the RMSE of many seeds") {
    const PictureSettings tiny = small(Method::mc, 10, 5);
    PictureSettings other = tiny;
    other.seed = 100;
    CHECK(relative(pilot_rmse(scene, {desert}, tiny), pilot_rmse(scene, {desert}, other)) < 0.15);
}

// Measured: 0.91 to 1.06 of what is asked.
TEST_CASE("as many samples are chosen as have the RMSE that is asked for, also under light finer than the samples") {
    for (const auto& [map, target] : {std::pair(&desert, 0.02), {&stripes, 0.05}}) {
        const Truth truth = truth_of(dense_picture(*map));
        for (const Placement placement : {Placement::uniform, Placement::fibonacci}) {
            PictureSettings settings = small(Method::pool, 1, 40, placement);
            const ChosenSamples chosen = samples_for(target, 1000, scene, {*map}, settings);
            CHECK(chosen.rmse <= target);
            settings.samples = chosen.samples;
            double squares = 0;
            for (settings.seed = 100; settings.seed < 120; ++settings.seed)
                squares += std::pow(image_error(picture(scene, {*map}, settings), truth).rmse, 2) / 20;
            const double achieved = std::sqrt(squares) / target;
            CAPTURE(achieved);
            CHECK(achieved > 0.75);
            CHECK(achieved < 1.2);
        }
    }
}

TEST_CASE("an easy RMSE takes 2 samples, an unreachable one is refused with what the most samples have") {
    const PictureSettings settings = small(Method::pool, 1, 20);
    CHECK(samples_for(1, 4096, scene, {desert}, settings).samples == 2);
    CHECK(samples_for(1e9, 4096, scene, prefilter(desert), settings).samples == 2);
    const std::string refusal = message_of([&] { samples_for(1e-9, 6, scene, {desert}, settings); });
    CHECK(contains(refusal, "an RMSE of 1e-09 is out of reach: 6 samples, the most allowed, have one of 0.0"));
    CHECK(samples_for(1e-9, 4096, scene, {even_map(1, 1, 0)}, settings).rmse == 0);
}

TEST_CASE("a pilot of one rule is a pool: whether the rule is a lucky one changes no number of samples") {
    const double pool = samples_for(0.02, 1000, scene, {desert}, small(Method::pool, 20, 20)).rmse;
    for (const Method method : {Method::single, Method::rotated, Method::direct})
        CHECK(samples_for(0.02, 1000, scene, {desert}, small(method, 20, 20)).rmse == pool);
}

TEST_CASE("an RMSE under a sun is refused unless the light is known") {
    const auto asked = [](Known known) {
        const PictureSettings settings = small(Method::pool, 1, 10, Placement::cosine_fibonacci, known);
        return asked_picture(sunny, settings, {Show::picture, 1}, Format::pfm);
    };
    for (const Known known : {Known::nothing, Known::cosine}) CHECK_THROWS_AS(asked(known), UsageError);
    CHECK_NOTHROW(asked(Known::light));
}
