#include "../course/judge/judge_picture.h"

#include "test.h"

namespace {

constexpr int side = 60;
const Camera camera{side, side};

PictureSettings settings_of(Method method, std::size_t samples = 40) {
    PictureSettings settings;
    settings.method = method;
    settings.samples = samples;
    settings.width = settings.height = side;
    settings.seed = 5;
    return settings;
}

Image rendered(Method method) { return render(sphere_scene(), desert, settings_of(method)); }

PictureFile written(const Image& image, bool as_floats = false) {
    return TextReader<PictureFile>{read_picture}(as_floats ? to_pfm(image) : to_ppm(image));
}

PictureFile rounded_down(const Image& image, int maxval) {
    std::string text = formatted("P3 %d %d %d\n", image.width(), image.height(), maxval);
    for (const float v : image.rgb()) text += formatted("%d ", static_cast<int>(maxval * srgb_encoded(v)));
    return TextReader<PictureFile>{read_picture}(text);
}

Judgement judged(const PictureFile& picture, const EnvironmentMap& map, const PictureSettings& settings) {
    return judge(picture, expect(prefilter(map), settings, picture));
}
Judgement judged(const PictureFile& picture, Method method) { return judged(picture, desert, settings_of(method)); }

void check_fits(const Judgement& judgement) {
    for (const Quantity& quantity : judgement.comparison.quantities) CHECK_MESSAGE(quantity.fits(), quantity.name);
}

// What is said of a wrong picture of a pool.
std::string reason(const Image& image, bool as_floats = false) {
    static const EnvironmentLight light = prefilter(desert);
    static const Expected codes = expect(light, settings_of(Method::pool), written(image)),
                          floats = expect(light, settings_of(Method::pool), written(image, true));
    const Judgement judgement = judge(written(image, as_floats), as_floats ? floats : codes);
    CHECK(!judgement.comparison.fits());
    return judgement.reason;
}

bool shows_object(int x, int y) { return intersect(sphere_scene(), camera.ray(x, y)).has_value(); }

// Every object's pixel by f(its colour, its hit, x).
template <class Function>
Image with_objects(Image image, Function f) {
    for_each_hit(sphere_scene(), camera,
                 [&](int x, int y, const Hit& hit) { image.set(x, y, f(image(x, y), hit, x)); });
    return image;
}

}  // namespace

TEST_CASE("a program that rounds codes down and shows single texels in the background is correct") {
    const Image image = rendered(Method::pool);
    const Image texels = image_of(side, side, [&](int x, int y) {
        return shows_object(x, y) ? image(x, y) : desert.radiance(camera.ray(x, y).direction);
    });
    for (const int maxval : {255, 31}) {
        CAPTURE(maxval);
        check_fits(judged(rounded_down(texels, maxval), Method::pool));
    }
}

TEST_CASE("under an even light, all of whose codes are rounded alike, both ways to round are correct" *
          doctest::test_suite("long")) {
    for (const double light : {0.5, 1.0}) {
        CAPTURE(light);
        const EnvironmentMap even = even_map(4, 2, light);
        const PictureSettings settings = settings_of(Method::mc, 400);  // so that half a code shows
        const Image image = render(sphere_scene(), even, settings);
        for (const PictureFile& picture : {written(image), rounded_down(image, 255)})
            check_fits(judged(picture, even, settings));
    }
}

TEST_CASE("under a light of black and white texels, both ways to round codes are correct" *
          doctest::test_suite("long")) {
    PictureSettings settings = settings_of(Method::pool);
    settings.width = settings.height = 100;
    settings.placement = Placement::cosine_fibonacci;
    settings.known = Known::cosine;
    const EnvironmentMap map = load_environment("black-and-white");
    const Image image = render(sphere_scene(), map, settings);
    for (const PictureFile& picture : {written(image), rounded_down(image, 255)})
        check_fits(judged(picture, map, settings));
}

TEST_CASE("a wrong factor, geometry or transfer function is found and named" * doctest::test_suite("long")) {
    const Image image = rendered(Method::pool);
    const auto times = [&](double factor) {
        return with_objects(image, [&](Color c, const Hit&, int) { return factor * c; });
    };
    const auto pixels = [&](auto pixel) { return image_of(side, side, pixel); };
    CHECK(reason(times(pi)) == "likely: one factor for all objects, 3.14: perhaps 1 / pi is missing, or pi too often");
    CHECK(reason(times(0.5), true) ==
          "likely: one factor for all objects, 0.5: perhaps weights pi / N in place of 2 pi / N");
    CHECK(contains(reason(times(1 / (2 * pi))), "0.159: perhaps 2 pi is missing"));
    CHECK(contains(reason(times(2 * pi / 40)), ": perhaps 2 pi is missing; or 2 pi / N too often"));
    CHECK(reason(times(0)) == "likely: one factor for all objects, 0: perhaps nothing is added up");
    CHECK(reason(pixels([&](int x, int y) { return image(x, side - 1 - y); })) == "likely: upside down");
    CHECK(contains(reason(pixels([&](int x, int y) { return image(side - 1 - x, y); })), "likely: mirrored"));
    CHECK(reason(pixels([&](int x, int y) { return shows_object(x, y) ? image(x, y) : Color{}; })) ==
          "likely: the background is black");
    CHECK(reason(pixels([&](int x, int y) {
              const Color c = image(x, y);
              return Color{c.z, c.y, c.x};
          })) == "likely: red and blue exchanged");
    CHECK(contains(reason(each_channel(image, srgb_decoded)), "likely: linear values in a PPM"));
    CHECK(contains(reason(each_channel(image, srgb_encoded)), "likely: encoded by the sRGB curve twice"));
    CHECK(contains(reason(each_channel(image, srgb_encoded), true), "likely: sRGB codes in a PFM"));
    const Image without_albedo = with_objects(image, [](Color c, const Hit& hit, int) {
        return Color{c.x / hit.albedo.x, c.y / hit.albedo.y, c.z / hit.albedo.z};
    });
    CHECK(contains(reason(without_albedo), "likely: the albedo is missing"));
}

TEST_CASE("an unknown mistake is not named; the verdict says where it errs" * doctest::test_suite("long")) {
    const Image image = rendered(Method::pool);
    const auto said = [&](auto change) { return reason(with_objects(image, change)); };
    CHECK(said([](Color c, const Hit&, int) { return 0.9 * c; }) == "it errs on all objects alike: 10 % too dark");
    CHECK(contains(said([](Color c, const Hit&, int) { return Color{1.1, 1, 1} * c; }), ": red 10 % too bright"));
    CHECK(contains(said([](Color c, const Hit& hit, int) { return (hit.object == Object::sphere ? 0.9 : 1) * c; }),
                   "it errs most on the sphere: "));
    CHECK(contains(said([](Color c, const Hit& hit, int) { return (hit.object == Object::sphere ? 1 : 0.9) * c; }),
                   "it errs most on the rectangle: "));
    CHECK(contains(
        reason(image_of(side, side, [&](int x, int y) { return image(shows_object(x, y) ? x : (x + 1) % side, y); })),
        "it errs most in the background, of which "));
    CHECK(contains(reason(Image(side, side)), "it errs most in the background, of which "));
    Random random(3, 0);
    CHECK(said([&](Color c, const Hit&, int) { return (0.9 + 0.2 * random.uniform()) * c; }).empty());
}

TEST_CASE("blurred objects are found, and said to share nothing" * doctest::test_suite("long")) {
    for (const Method method : {Method::pool, Method::rotated, Method::single}) {
        const Image image = rendered(method);
        const auto blurred = [&](int x, int y) {
            Color sum;
            double count = 0;
            for (int i = 0; i < 9; ++i) {
                const int column = x + i % 3 - 1, row = y + i / 3 - 1;
                if (!shows_object(x, y) || !shows_object(column, row)) continue;
                sum += image(column, row);
                count += 1;
            }
            return count == 0 ? image(x, y) : 1 / count * sum;
        };
        const Judgement judgement = judged(written(image_of(side, side, blurred)), method);
        CHECK(!judgement.comparison.fits());
        CHECK(!contains(judgement.reason, "share"));
    }
}

TEST_CASE("what stands elsewhere by a pixel is told by the outline" * doctest::test_suite("long")) {
    const Image image = rendered(Method::pool);
    const auto moved = [&](int x, int y) {  // objects a pixel to the right, before the same background
        if (x > 0 && shows_object(x - 1, y)) return image(x - 1, y);
        return shows_object(x, y) ? desert.radiance(camera.ray(x, y).direction) : image(x, y);
    };
    CHECK(reason(image_of(side, side, moved)) == "the outline of the objects differs: camera, sphere or rectangle");
}

TEST_CASE("a wrong integrand is found and named: cos(theta) twice, no cos(theta), no shadows" *
          doctest::test_suite("long")) {
    const Image background = rendered(Method::mc);
    const auto shaded = [&](double power, bool shadows) {
        QuadratureRule rule{fibonacci_directions(2000), {}};
        for (const Vec3& w : rule.directions) rule.weights.push_back(pi / 1000 * portable::pow(w.y, power - 1));
        return with_objects(background, [&](Color, const Hit& hit, int) {
            return plain_light(sphere_scene(), desert, hit, rule, Frame(hit.normal), shadows);
        });
    };
    CHECK(reason(shaded(2, true)) == "likely: cos(theta) twice");
    CHECK(reason(shaded(0, true)) == "likely: cos(theta) is missing");
    CHECK(reason(shaded(1, false)) == "likely: no shadows");
}

TEST_CASE("streaks are found, and the pixels that share random numbers are named") {
    const Truth truth = dense_truth(prefilter(desert), settings_of(Method::mc), 500);
    std::vector<double> noise;  // of every column, about as much as a pool has
    Random random(3, 0);
    for (int x = 0; x < side; ++x) noise.push_back(1 + 0.16 * (random.uniform() - 0.5));
    const Judgement judgement =
        judged(written(with_objects(
                   truth.image, [&](Color c, const Hit&, int x) { return noise[static_cast<std::size_t>(x)] * c; })),
               Method::pool);
    CHECK(!judgement.comparison["repeats"].fits());
    CHECK(judgement.comparison["correlation"].fits());
    CHECK(contains(judgement.reason, "repeat 0 columns and"));
}

TEST_CASE("a rule that is not turned is found and named" * doctest::test_suite("long")) {
    PictureSettings settings = settings_of(Method::single);
    settings.seed = 6;
    const PictureFile picture = written(render(sphere_scene(), desert, settings));
    CHECK(judged(picture, Method::rotated).reason ==
          "likely: neighbouring pixels share random numbers, or rules that are not turned");
}

TEST_CASE("neighbours that err alike by another mistake share no noise" * doctest::test_suite("long")) {
    const Image darker = with_objects(rendered(Method::rotated), [](Color c, const Hit&, int) { return 0.9 * c; });
    const Judgement judgement = judged(written(darker), Method::rotated);
    CHECK(!judgement.comparison["alike"].fits());
    CHECK(contains(judgement.reason, "it errs on all objects alike: "));
}

TEST_CASE("numbers that are common each, but not together, are found" * doctest::test_suite("long")) {
    Random random(7, 0);
    const Image noisy = with_objects(rendered(Method::rotated),
                                     [&](Color c, const Hit&, int) { return (0.75 + 0.5 * random.uniform()) * c; });
    // An unlucky rule errs as much as this noise, but not pixel by pixel.
    const Comparison comparison = judged(written(noisy), Method::rotated).comparison;
    for (const char* name : {"rmse", "brightness", "correlation", "alike", "block"})
        CHECK_MESSAGE(comparison[name].fits(), name);
    CHECK(!comparison["together"].fits());
}

TEST_CASE("one rule that meets a small sun or does not makes pictures of two kinds, both correct" *
          doctest::test_suite("long")) {
    const EnvironmentMap sun = map_of(1024, 512, [](int column, int row) {
        return (column == 160 && row == 120 ? 1000 : 0.5) * Color{1, 1, 1};
    });
    double rmse[2];
    for (const std::uint64_t seed : {5u, 6u}) {
        PictureSettings settings = settings_of(Method::rotated);
        settings.seed = seed;
        const Comparison comparison =
            judged(written(render(sphere_scene(), sun, settings), true), sun, settings).comparison;
        CHECK(comparison.fits());
        rmse[seed - 5] = comparison["rmse"].measured;
    }
    CHECK(rmse[1] > 50 * rmse[0]);
}

TEST_CASE("a picture too small to judge, and an environment without light, are refused") {
    CHECK_THROWS_WITH_AS(judged({Image(34, 26), 255}, Method::pool),
                         "34 x 26 pixels are too few to judge: 498 show an object, 500 should", std::invalid_argument);
    CHECK_NOTHROW(judged({Image(30, 27), 255}, Method::pool));  // of which 500 do
    const EnvironmentMap night = even_map(1, 1, 0);
    CHECK_THROWS_WITH_AS(judged(written(rendered(Method::mc)), night, settings_of(Method::mc)),
                         "the environment lights no object, so there is nothing to judge; take another",
                         std::invalid_argument);
}
