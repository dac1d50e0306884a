#include "light/load_environment.h"
#include "test.h"

TEST_CASE("the desert's radiances lie in [0, 1], and the bright desert has but a sun a thousand times as bright") {
    const EnvironmentMap desert = load_environment(), bright = load_environment("bright-desert", 2);
    REQUIRE((desert.width() == 1024 && desert.height() == 512 && bright.width() == 1024));
    const Vec3 sun{0.8, 0.48, 0.36};
    CHECK(std::fabs(bright.radiance(sun).x / desert.radiance(sun).x - 1000) < 1e-3);  // floats
    double least = 1, most = 0;
    int wrong = 0;
    for (int i = 0; i < 1023 * 511; ++i) {
        const int x = i % 1023, y = i / 1023, texel = desert.index(x, y);
        const Color a = desert.color(texel), b = bright.color(texel);
        const double to_sun = dot(towards((x + 0.5) / 1023, (y + 0.5) / 511), sun);
        wrong += to_sun < std::cos(pi / 30) && !same(a, b);         // beyond 6 degrees
        wrong += to_sun > std::cos(pi / 45) && !(b.x > 900 * a.x);  // within 4 degrees
        least = std::min({least, a.x, a.y, a.z});
        most = std::max({most, a.x, a.y, a.z});
    }
    CHECK((wrong == 0 && least >= 0 && least < 0.1 && most > 0.9 && most <= 1));
}

TEST_CASE("black and white is light from every direction with x > 0, and none from elsewhere") {
    const EnvironmentMap map = load_environment("black-and-white");
    for (const Vec3& w : all_around(1000))  // a column is 0.006 wide
        if (std::fabs(w.x) > 0.01) CHECK(same(map.radiance(w), w.x > 0 ? Color{1, 1, 1} : Color{}));
}

TEST_CASE("a light from a file has the file's texels, and an error names the file") {
    const TemporaryFile good("#?RADIANCE\n\n-Y 1 +X 2\n\200\100\40\201\200\100\40\204");
    CHECK(load_environment(good.name).width() == 2);
    CHECK(same(load_environment(good.name).color(2), {8, 4, 2}));
    std::ofstream(good.name) << "P6";
    CHECK(message_of([&] { load_environment(good.name); }) ==
          good.name + ": not a Radiance picture: its first line should be #?RADIANCE or #?RGBE");
    CHECK(message_of([&] { load_environment("no such file"); }) ==
          "no such file: no file that can be read has this name, and no built-in light: they are desert, bright-desert "
          "and black-and-white");
}
