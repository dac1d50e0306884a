// What tests/course/tests/check_judge does not try: other files, other lights, the causes that are named.
#include "../course/judge/judge_picture.h"

#include "test.h"

namespace {

constexpr int side = 60;
const Camera camera{side, side};

PictureSettings settings_of(Method method, std::size_t samples = 40) {
    PictureSettings settings = small(method, samples, side);
    settings.seed = 5;
    return settings;
}

Image rendered(Method method) { return render(sphere_scene(), desert, settings_of(method)); }

PictureFile written(const Image& image, bool as_floats = false) {
    return TextReader<PictureFile>{read_picture}(as_floats ? to_pfm(image) : to_ppm(image));
}

PictureFile rounded_down(const Image& image, int maxval = 255) {
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

// Whether this is said of a wrong picture of a pool.
bool says(const std::string& words, const Image& image, bool as_floats = false) {
    static const EnvironmentLight light = prefilter(desert);
    static const Expected codes = expect(light, settings_of(Method::pool), written(image)),
                          floats = expect(light, settings_of(Method::pool), written(image, true));
    const Judgement judgement = judge(written(image, as_floats), as_floats ? floats : codes);
    INFO(judgement.reason);
    CHECK(!judgement.comparison.fits());
    return contains(judgement.reason, words);
}

bool shows_object(int x, int y) { return intersect(sphere_scene(), camera.ray(x, y)).has_value(); }

// Every object's pixel by f(its colour, its hit).
template <class Function>
Image with_objects(Image image, Function f) {
    for_each_hit(sphere_scene(), camera, [&](int x, int y, const Hit& hit) { image.set(x, y, f(image(x, y), hit)); });
    return image;
}

}  // namespace

TEST_CASE("a program that rounds codes down and shows single texels in the background is correct") {
    const Image image = rendered(Method::pool);
    const Image texels = image_of(side, side, [&](int x, int y) {
        return shows_object(x, y) ? image(x, y) : desert.radiance(camera.ray(x, y).direction);
    });
    for (const int maxval : {255, 31}) check_fits(judged(rounded_down(texels, maxval), Method::pool));
}

TEST_CASE("where the background does not tell how codes are rounded, both ways are correct" *
          doctest::test_suite("long")) {
    PictureSettings half_a_code_shows = settings_of(Method::mc, 400), black_and_white = settings_of(Method::pool);
    black_and_white.width = black_and_white.height = 100;
    black_and_white.placement = Placement::cosine_fibonacci;
    black_and_white.known = Known::cosine;
    for (const auto& [map, settings] : {std::pair(even_map(4, 2, 0.5), half_a_code_shows),
                                        {white, half_a_code_shows},
                                        {load_environment("black-and-white"), black_and_white}}) {
        const Image image = render(sphere_scene(), map, settings);
        for (const PictureFile& picture : {written(image), rounded_down(image)})
            check_fits(judged(picture, map, settings));
    }
}

TEST_CASE("a wrong factor, geometry or transfer function is found and named" * doctest::test_suite("long")) {
    const Image image = rendered(Method::pool);
    const auto times = [&](double factor) {
        return with_objects(image, [&](Color c, const Hit&) { return factor * c; });
    };
    const auto pixels = [&](auto pixel) { return image_of(side, side, pixel); };
    CHECK(says("objects, 3.14: perhaps 1 / pi is missing, or pi too often", times(pi)));
    CHECK(says("objects, 0.5: perhaps weights pi / N in place of 2 pi / N", times(0.5), true));
    CHECK(says(": perhaps 2 pi is missing; or 2 pi / N too often", times(2 * pi / 40)));
    CHECK(says("objects, 0: perhaps nothing is added up", times(0)));
    CHECK(says("likely: upside down", pixels([&](int x, int y) { return image(x, side - 1 - y); })));
    CHECK(says("likely: mirrored", pixels([&](int x, int y) { return image(side - 1 - x, y); })));
    CHECK(says("likely: the background is black",
               pixels([&](int x, int y) { return shows_object(x, y) ? image(x, y) : Color{}; })));
    CHECK(says("likely: red and blue exchanged", pixels([&](int x, int y) {
                   return Color{image(x, y).z, image(x, y).y, image(x, y).x};
               })));
    CHECK(says("likely: linear values in a PPM", each_channel(image, srgb_decoded)));
    CHECK(says("likely: encoded by the sRGB curve twice", each_channel(image, srgb_encoded)));
    CHECK(says("likely: sRGB codes in a PFM", each_channel(image, srgb_encoded), true));
    CHECK(says("likely: the albedo is missing", with_objects(image, [](Color c, const Hit& hit) {
                   return Color{c.x / hit.albedo.x, c.y / hit.albedo.y, c.z / hit.albedo.z};
               })));
}

TEST_CASE("a wrong integrand is found and named" * doctest::test_suite("long")) {
    for (const auto& [words, power, shadows] : {std::tuple("likely: cos(theta) twice", 2, true),
                                                {"likely: cos(theta) is missing", 0, true},
                                                {"likely: no shadows", 1, false}}) {
        QuadratureRule rule{fibonacci_directions(2000), {}};
        for (const Vec3& w : rule.directions) rule.weights.push_back(pi / 1000 * std::pow(w.y, power - 1));
        CHECK(says(words, with_objects(rendered(Method::mc), [&, with = shadows](Color, const Hit& hit) {
                       return plain_light(sphere_scene(), desert, hit, rule, Frame(hit.normal), with);
                   })));
    }
}

TEST_CASE("an unknown mistake is not named; the verdict says where it errs" * doctest::test_suite("long")) {
    const auto image = rendered(Method::pool);
    const auto times = [&](Color sphere, Color rectangle) {
        return with_objects(
            image, [=](Color c, const Hit& hit) { return (hit.object == Object::sphere ? sphere : rectangle) * c; });
    };
    const Color same{1, 1, 1}, darker = 0.9 * same, redder{1.1, 1, 1};
    CHECK(says("it errs on all objects alike: 10 % too dark", times(darker, darker)));
    CHECK(says(": red 10 % too bright", times(redder, redder)));
    CHECK(says("it errs most on the sphere: ", times(darker, same)));
    CHECK(says("it errs most on the rectangle: ", times(same, darker)));
    CHECK(says("it errs most in the background, of which ", Image(side, side)));
    Random random(3, 0);
    const Image noisy = with_objects(image, [&](Color c, const Hit&) { return (0.9 + 0.2 * random.uniform()) * c; });
    CHECK(judged(written(noisy), Method::pool).reason.empty());
}

TEST_CASE("neighbours that err alike by another mistake share no noise" * doctest::test_suite("long")) {
    const Image darker = with_objects(rendered(Method::rotated), [](Color c, const Hit&) { return 0.9 * c; });
    const Judgement judgement = judged(written(darker), Method::rotated);
    CHECK(!judgement.comparison["alike"].fits());
    CHECK(contains(judgement.reason, "it errs on all objects alike: "));
}

TEST_CASE("one rule that meets a small sun or does not makes pictures of two kinds, both correct" *
          doctest::test_suite("long")) {
    const EnvironmentMap sun = map_of(1024, 512, [](int column, int row) {
        return (column == 160 && row == 120 ? 1000 : 0.5) * Color{1, 1, 1};
    });
    PictureSettings settings = settings_of(Method::rotated);
    for (settings.seed = 5; settings.seed <= 6; ++settings.seed)  // errors of 1 and of more than 50
        check_fits(judged(written(render(sphere_scene(), sun, settings), true), sun, settings));
}

TEST_CASE("a picture too small to judge, and an environment without light, are refused") {
    CHECK_THROWS_WITH_AS(judged({Image(34, 26), 255}, Method::pool),
                         "34 x 26 pixels are too few to judge: 498 show an object, 500 should", std::invalid_argument);
    CHECK_NOTHROW(judged({Image(30, 27), 255}, Method::pool));  // of which 500 do
    CHECK_THROWS_WITH_AS(judged({Image(side, side), 255}, even_map(1, 1, 0), settings_of(Method::mc)),
                         "the environment lights no object, so there is nothing to judge; take another",
                         std::invalid_argument);
}
