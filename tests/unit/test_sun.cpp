#include "beyond/sun.h"
#include "test.h"

using namespace bmc::beyond;

TEST_CASE("the sun is the texels of more than ten times the mean radiance") {
    EnvironmentMap map = even_map(64, 32, 1);
    const int place = map.index(50, 10);
    const double part = TexelsOnSphere(map).solid_angle(10) / (4 * pi);
    const double threshold = 10 * (1 - part) / (1 - 10 * part);  // 10 (part radiance + 1 - part)
    for (const double radiance : {0.999 * threshold, 1.001 * threshold}) {
        map.set(50, 10, {radiance, radiance, radiance});
        const Sun sun(map);
        const bool shines = radiance > threshold;
        CAPTURE(radiance);
        CHECK(sun.empty() == !shines);
        CHECK(std::fabs(sun.light() - shines * 4 * pi * part * 3 * radiance) < 1e-5);  // floats
        CHECK(std::fabs(sun.share() - shines * part * radiance / (1 - part + part * radiance)) < 1e-6);
        CHECK(sun.sky(map)->colour(place).x == (shines ? 0 : map.colour(place).x));
        CHECK(sun.sky(map)->colour(place + 1).x == 1);
    }
}

// A texel at the pole, 22.5 degrees high and wide: the azimuth goes with u, y with v.
TEST_CASE("the sun's rays go anywhere in its texels, uniformly w.r.t. solid angle") {
    const EnvironmentMap map = map_of(17, 9, [](int x, int y) { return (y == 0 && x == 12) * Colour{3, 2, 1}; });
    const Sun sun(map);
    for (const double u : {0.0, 0.1, 0.5, 0.99})
        for (const double v : {0.01, 0.5, 0.99}) {
            const auto [direction, colour] = sun.ray(u, v);
            INFO("u, v: ", u, ", ", v);
            CHECK(colour == Vec3{0.5, 1.0 / 6 * 2, 1.0 / 6});
            CHECK(std::fabs(std::atan2(direction.x, -direction.z) - ((12 + u) / 8 - 1) * pi) < 1e-12);
            CHECK(std::fabs(direction.y - (1 - v * (1 - std::cos(pi / 8)))) < 1e-12);
        }
    CHECK(sun.ray(1, 0.5).colour == sun.ray(0.5, 0.5).colour);  // (j + u) / m can round to 1
    CHECK(relative(sun.light(), 6 * 2 * pi / 16 * (1 - std::cos(pi / 8))) < 1e-12);
}

// Of two pieces of a map the second one is passed after the first, however wide the map is.
TEST_CASE("the fraction u of the light is passed texel by texel, in Morton's order") {
    const EnvironmentMap map = map_of(8193, 9, [](int x, int y) {
        return (x % 4096 < 4 && x < 8192 && y / 2 == 1) * Colour{1, 1, 1};
    });
    const Sun sun(map);
    std::vector<int> passed;  // 100 piece + 10 row + column
    for (double u = 0.003; u < 1; u += 0.01) {
        const int i = map.index(sun.ray(u, 0.5).direction) - 1, x = i % 8193;
        const int place = x / 4096 * 100 + i / 8193 * 10 + x % 4096;
        if (passed.empty() || passed.back() != place) passed.push_back(place);
    }
    CHECK(passed == std::vector<int>{20, 21, 30, 31, 22, 23, 32, 33, 120, 121, 130, 131, 122, 123, 132, 133});
}

// The variance of a direction that is even in an arc is a twelfth of its squared length.
TEST_CASE("the spread of the sun is the deviation of its directions") {
    const auto spread_of = [](std::vector<int> columns) {
        EnvironmentMap map(513, 257);
        for (const int column : columns) map.set(column, 128, {1, 1, 1});
        return Sun(map).spread();
    };
    CHECK(relative(spread_of({7}), 2 * pi / 512 / std::sqrt(12)) < 1e-3);
    CHECK(relative(spread_of({7, 8, 9}), 6 * pi / 512 / std::sqrt(12)) < 1e-3);
    CHECK(relative(spread_of({7, 7 + 256}), 1) < 1e-3);
}

TEST_CASE("a fraction is visible over all light, from 0 to 1, and 1 where there is no light") {
    CHECK(RatioEstimator{{2, -1, 8}, {1, -2, 16}}.fraction() == Vec3{0.5, 1, 1});
    CHECK(RatioEstimator{{0, 1, 1}, {0, -1, 0}}.fraction() == Vec3{1, 0, 0});
}
