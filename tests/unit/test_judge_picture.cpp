#include "../course/judge/judge_picture.h"

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "quadrature/covariance.h"
#include "scene/desert.h"

namespace {

constexpr int side = 60;

PictureSettings settings_of(Method method, std::size_t samples = 40) {
    PictureSettings settings;
    settings.method = method;
    settings.samples = samples;
    settings.width = settings.height = side;
    settings.seed = 5;
    return settings;
}

const EnvironmentMap& desert() {
    static const EnvironmentMap map = load_environment();
    return map;
}

Image rendered(Method method, std::size_t samples = 40) {
    return render(sphere_scene(), desert(), settings_of(method, samples));
}

PictureFile written(const Image& image, bool as_floats = false) {
    std::istringstream file(as_floats ? to_pfm(image) : to_ppm(image));
    return read_picture(file);
}

PictureJudgement judged(const PictureFile& picture, Method method) {
    return judge_picture(picture, desert(), settings_of(method));
}

// Every pixel is that of f(x, y).
template <class Pixel>
Image changed(Pixel pixel) {
    Image image(side, side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) image.set(x, y, pixel(x, y));
    return image;
}

bool shows_object(int x, int y) { return intersect(sphere_scene(), Camera{side, side}.ray(x, y)).has_value(); }

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("pictures of every method are within what correct programs do, as codes and as floats" *
          doctest::test_suite("long")) {
    for (const auto& each : method_names) {
        CAPTURE(each.first);
        const Method method = each.second;
        const PictureJudgement judgement = judged(written(rendered(method), method == Method::pool), method);
        for (const Quantity& quantity : judgement.comparison.quantities) CHECK_MESSAGE(quantity.fits(), quantity.name);
        CHECK(judgement.fits());
        CHECK(judgement.mistake.empty());
    }
}

TEST_CASE("a program that rounds codes down and shows single texels in the background is correct") {
    const Image image = rendered(Method::pool);
    for (const int maxval : {255, 31}) {
        CAPTURE(maxval);
        std::string text = "P3 60 60 " + std::to_string(maxval) + '\n';
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const Vec3 direction = Camera{side, side}.ray(x, y).direction;
                const Color c = shows_object(x, y) ? image(x, y) : desert().radiance(direction);
                for (const double v : {c.x, c.y, c.z})
                    text += std::to_string(static_cast<int>(maxval * srgb_encoded(v))) + ' ';
            }
        std::istringstream file(text);
        const PictureJudgement judgement = judged(read_picture(file), Method::pool);
        for (const Quantity& quantity : judgement.comparison.quantities) CHECK_MESSAGE(quantity.fits(), quantity.name);
    }
}

TEST_CASE("a wrong factor, geometry or transfer function is found and named" * doctest::test_suite("long")) {
    const Image image = rendered(Method::pool);
    const auto scaled = [&](double factor) {
        return changed([&](int x, int y) { return shows_object(x, y) ? factor * image(x, y) : image(x, y); });
    };
    const auto mistake = [&](const Image& picture, bool as_floats = false) {
        const PictureJudgement judgement = judged(written(picture, as_floats), Method::pool);
        CHECK(!judgement.fits());
        return judgement.mistake;
    };
    CHECK(contains(mistake(scaled(portable::pi)), "1 / pi is missing"));
    CHECK(contains(mistake(scaled(0.5), true), "pi / N"));
    CHECK(contains(mistake(changed([&](int x, int y) {
                       const Color c = image(x, y);
                       const double grey = (c.x + c.y + c.z) / 3;
                       return shows_object(x, y) ? Color{grey, grey, grey} : c;
                   })),
                   ""));
    CHECK(contains(mistake(scaled(1 / (2 * portable::pi))), "2 pi is missing"));
    CHECK(contains(mistake(changed([&](int x, int y) { return image(x, side - 1 - y); })), "upside down"));
    CHECK(contains(mistake(changed([&](int x, int y) { return image(side - 1 - x, y); })), "mirrored"));
    CHECK(contains(mistake(changed([&](int x, int y) { return shows_object(x, y) ? image(x, y) : Color{}; })),
                   "background is black"));
    CHECK(contains(mistake(changed([&](int x, int y) { return image(shows_object(x, y) ? x : (x + 1) % side, y); })),
                   ""));
    CHECK(contains(mistake(changed([&](int x, int y) {
                       const Color c = image(x, y);
                       return Color{srgb_decoded(c.x), srgb_decoded(c.y), srgb_decoded(c.z)};
                   })),
                   "linear values in a PPM"));
}

TEST_CASE("a wrong integrand is found and named: cos(theta) twice, no cos(theta), no shadows" *
          doctest::test_suite("long")) {
    const Image background = rendered(Method::mc);
    const std::vector<Vec3> directions = cosine_fibonacci_directions(500);
    const auto shaded = [&](double power, bool shadows) {
        return changed([&](int x, int y) {
            const auto hit = intersect(sphere_scene(), Camera{side, side}.ray(x, y));
            if (!hit) return background(x, y);
            const Frame frame(hit->normal);
            const Scene scene = sphere_scene();
            Color sum;
            for (const Vec3& local : directions) {
                const Vec3 direction = frame.to_world(local);
                if (!shadows || !is_shadowed(scene, *hit, direction))
                    sum = sum + portable::pow(local.y, power) * desert().radiance(direction);
            }
            return 1.0 / 500 * Color{hit->albedo.x * sum.x, hit->albedo.y * sum.y, hit->albedo.z * sum.z};
        });
    };
    // The directions have the density cos(theta) / pi already.
    CHECK(judged(written(shaded(1, true)), Method::pool).mistake == "cos(theta) twice");
    CHECK(judged(written(shaded(-1, true)), Method::pool).mistake == "cos(theta) is missing");
    CHECK(judged(written(shaded(0, false)), Method::pool).mistake == "no shadows");
}

TEST_CASE("a picture of another method is found and named" * doctest::test_suite("long")) {
    const auto mistake = [](Method made, Method wanted) {
        const PictureJudgement judgement = judged(written(rendered(made)), wanted);
        CHECK(!judgement.fits());
        return judgement.mistake;
    };
    CHECK(contains(mistake(Method::single, Method::pool), "--method single"));
    CHECK(contains(mistake(Method::single, Method::rotated), "--method single"));
    CHECK(contains(mistake(Method::mc, Method::direct), "--method mc"));
    CHECK(contains(mistake(Method::mc, Method::rotated), "--method mc"));
    const PictureJudgement few = judged(written(rendered(Method::direct, 10)), Method::direct);
    CHECK(!few.comparison["rmse"].fits());
    CHECK(contains(few.mistake, "--samples 10"));
}

TEST_CASE("streaks are found, and the pixels that share random numbers are named") {
    PictureSettings dense = settings_of(Method::mc, 500);
    dense.placement = Placement::cosine_fibonacci;
    dense.set_known(Known::light);
    const PrefilteredEnvironment prefiltered(desert());
    const Image truth = picture(sphere_scene(), {desert(), &prefiltered}, dense);
    std::vector<double> noise;  // of every column, about as much as a pool has
    Random random(3, 0);
    for (int x = 0; x < side; ++x) noise.push_back(1 + 0.12 * (random.uniform() - 0.5));
    const PictureJudgement judgement = judged(written(changed([&](int x, int y) {
                                                  const double factor = noise[static_cast<std::size_t>(x)];
                                                  return (shows_object(x, y) ? factor : 1) * truth(x, y);
                                              })),
                                              Method::pool);
    CHECK(!judgement.comparison["repeats"].fits());
    CHECK(judgement.comparison["correlation"].fits());
    CHECK(contains(judgement.mistake, "repeat 0 columns and"));
}

TEST_CASE("numbers that are common each, but not together, are found" * doctest::test_suite("long")) {
    const Image image = rendered(Method::rotated);
    Random random(7, 0);
    const Image noisy = changed([&](int x, int y) {
        const double factor = 0.75 + 0.5 * random.uniform();
        return shows_object(x, y) ? factor * image(x, y) : image(x, y);
    });
    // An unlucky rule errs as much as this noise, but not pixel by pixel.
    const PictureJudgement judgement = judged(written(noisy), Method::rotated);
    for (const char* name : {"rmse", "brightness", "correlation", "alike", "block"})
        CHECK_MESSAGE(judgement.comparison[name].fits(), name);
    CHECK(!judgement.comparison["together"].fits());
}

TEST_CASE("a picture is judged though its model refuses other numbers of samples" * doctest::test_suite("long")) {
    PictureSettings settings = settings_of(Method::pool, 10);
    settings.noise = 0;
    settings.covariance = CovarianceFamily::squared_exponential;
    PictureSettings more = settings;
    more.samples = 160;
    CHECK_THROWS_AS(render(sphere_scene(), desert(), more), NotPositiveDefinite);
    const Image image = render(sphere_scene(), desert(), settings);
    CHECK(judge_picture(written(image), desert(), settings).fits());
}

TEST_CASE("one rule that meets a small sun or does not makes pictures of two kinds, both correct" *
          doctest::test_suite("long")) {
    std::vector<float> rgb(3 * 1024 * 512, 0.5f);
    for (std::size_t i = 0; i < 3; ++i) rgb[3 * (120 * 1024 + 160) + i] = 1000;
    const EnvironmentMap sun(1024, 512, rgb);
    double rmse[2];
    for (const std::uint64_t seed : {5u, 6u}) {
        PictureSettings settings = settings_of(Method::rotated);
        settings.seed = seed;
        const Image image = render(sphere_scene(), sun, settings);
        const PictureJudgement judgement = judge_picture(written(image, true), sun, settings);
        CHECK(judgement.fits());
        rmse[seed - 5] = judgement.comparison["rmse"].here;
    }
    CHECK(rmse[1] > 50 * rmse[0]);
}

TEST_CASE("a picture too small to judge, and an environment without light, are refused") {
    CHECK_THROWS_WITH_AS(judged({Image(34, 26), 255}, Method::pool),
                         "34 x 26 pixels are too few to judge: 498 show an object, 500 should", std::invalid_argument);
    CHECK_NOTHROW(judged({Image(30, 27), 255}, Method::pool));  // of which 500 do
    const EnvironmentMap night(1, 1, {0, 0, 0});
    CHECK_THROWS_WITH_AS(judge_picture(written(rendered(Method::mc)), night, settings_of(Method::mc)),
                         "the environment lights no object, so there is nothing to judge; take another",
                         std::invalid_argument);
}
