#include "light/load_environment.h"
#include "test.h"

TEST_CASE("the desert's radiances fill [0, 1]") {
    const EnvironmentMap desert = load_environment();
    CHECK(desert.width() == 1024);
    CHECK(desert.height() == 512);
    double least = 1, most = 0;
    for (int i = 1; i <= 1024 * 512; ++i) {
        const Color a = desert.color(i);
        least = std::min({least, a.x, a.y, a.z});
        most = std::max({most, a.x, a.y, a.z});
    }
    CHECK(least >= 0);
    CHECK(least < 0.1);
    CHECK(most > 0.9);
    CHECK(most <= 1);
}

TEST_CASE("the bright desert is the desert with a sun a thousand times as bright") {
    const EnvironmentMap desert = load_environment(), bright = load_environment("bright-desert", 2);
    const Vec3 sun{0.8, 0.48, 0.36};
    CHECK(std::fabs(bright.radiance(sun).x / desert.radiance(sun).x - 1000) < 1e-3);  // floats
    int wrong = 0;
    for (int i = 0; i < 1023 * 511; ++i) {
        const int x = i % 1023, y = i / 1023, texel = desert.index(x, y);
        const Color a = desert.color(texel), b = bright.color(texel);
        const double to_sun = dot(towards((x + 0.5) / 1023, (y + 0.5) / 511), sun);
        wrong += to_sun < std::cos(pi / 30) && !(a == b);           // beyond 6 degrees
        wrong += to_sun > std::cos(pi / 45) && !(b.x > 900 * a.x);  // within 4 degrees
    }
    CHECK(wrong == 0);
}

TEST_CASE("black and white is light from every direction with x > 0") {
    const EnvironmentMap map = load_environment("black-and-white");
    for (const Vec3& w : all_around(1000))  // a column is 0.006 wide
        if (std::fabs(w.x) > 0.01) CHECK_MESSAGE(map.radiance(w).y == (w.x > 0), w);
}

TEST_CASE("a light from a file has the file's texels") {
    const TemporaryFile good("#?RADIANCE\n\n-Y 1 +X 2\n\200\100\40\201\200\100\40\204");
    CHECK(load_environment(good.name).width() == 2);
    CHECK(load_environment(good.name).color(2) == Vec3{8, 4, 2});
}

TEST_CASE("an error in the file of a light names the file") {
    const TemporaryFile bad("P6");
    CHECK(message_of([&] { load_environment(bad.name); }) ==
          bad.name + ": not a Radiance picture: its first line should be #?RADIANCE or #?RGBE");
    CHECK(message_of([&] { load_environment("no such file"); }) ==
          "no such file: no file that can be read has this name, and no built-in light: they are desert, bright-desert "
          "and black-and-white");
}
