#include "light/environment.h"
#include "test.h"

TEST_CASE("a map holds what it is made of, and texel 0 is black") {
    EnvironmentMap map(2, 2, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
    CHECK((map.width() == 2 && map.height() == 2));
    CHECK(same(map.color(0), {0, 0, 0}));
    CHECK(same(map.color(map.index(1, 0)), {4, 5, 6}));
    map.set(0, 1, {0.5, 0.25, 0});
    CHECK(same(map.color(3), {0.5, 0.25, 0}));
    CHECK(same(map.color(4), {10, 11, 12}));
    for (int i = 0; i <= 6; ++i) CHECK(same(EnvironmentMap(3, 2).color(i), {0, 0, 0}));
}

TEST_CASE("a map refuses sizes that do not match its values, and values that are no radiances") {
    const auto refusal = [](int width, int height, const std::vector<float>& rgb) {
        return message_of([&] { EnvironmentMap(width, height, rgb); });
    };
    CHECK(refusal(2, 2, {1, 2, 3}) ==
          "environment map of 2 x 2 texels with 3 values: it takes 1 to 67108864, of three values each");
    CHECK(contains(refusal(-1, -1, {1, 2, 3}), "-1 x -1"));
    CHECK(contains(refusal(65536, 65536, {}), "65536 x 65536"));
    for (const float value : {-0.5f, HUGE_VALF, -HUGE_VALF, std::nanf("")})
        CHECK(contains(refusal(1, 1, {1, 1, value}), formatted("environment map: %.9g is not", value)));
}

// The angles err by at most 2.3e-8.
TEST_CASE("column and row are u (W - 1) and v (H - 1) by atan2 and acos, within 4e-6 in a map 1024 wide") {
    const TexelGrid grid{1024, 512};
    for (const Vec3& d : all_around(20000)) {
        CHECK(std::fabs(grid.column(d.x, d.z) - 1023 * (1 + std::atan2(d.x, -d.z) / pi) / 2) < 4e-6);
        CHECK(std::fabs(grid.row(d.y) - 511 * std::acos(d.y) / pi) < 4e-6);
    }
}

TEST_CASE("a direction meets the texel at the floor of column and row; straight up and down it has the azimuth of -z") {
    const EnvironmentMap map = coloured_map(512, 256);
    const auto meets = [&](Vec3 direction, int column, int row) {
        return map.index(direction) == map.index(column, row) &&
               same(map.radiance(direction), map.color(map.index(column, row)));
    };
    CHECK(meets({0, 0, -1}, 255, 127));                                  // u = 1/2: 255.5, v = 1/2: 127.5
    CHECK((meets({1, 0, 0}, 383, 127) && meets({-1, 0, 0}, 127, 127)));  // u = 3/4: 383.25, u = 1/4: 127.75
    CHECK((meets({0, 0, 1}, 511, 127) && meets({0, 1, 0}, 255, 0) && meets({0, -1, 0}, 255, 255)));
    for (const Vec3& d : all_around(1000))
        CHECK(meets(d, static_cast<int>(map.grid().column(d.x, d.z)), static_cast<int>(map.grid().row(d.y))));
}

TEST_CASE("a direction that rounding has lengthened has a texel, in every octant and in maps of any size") {
    for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {512, 256}, {EnvironmentMap::max_texels, 1}})
        for (int octant = 0; octant < 8; ++octant)
            for (const Vec3& d : {Vec3{0, 1, 0}, {0, 0, 1}, {1e-300, 1, 0}, {1, 0, 1e-300}, {0.6, 0, 0.8}}) {
                const auto signed_by = [&](int bit, double x) { return (octant & bit ? -1 - 1e-15 : 1 + 1e-15) * x; };
                const double column = TexelGrid{width, height}.column(signed_by(1, d.x), signed_by(4, d.z));
                const double row = TexelGrid{width, height}.row(signed_by(2, d.y));
                CHECK((column > -1 && column < width && row > -1 && row < height));  // truncated towards 0
            }
}

TEST_CASE("interpolated radiance is the texel's at its centre, the mean half-way, and closed around the azimuth") {
    const EnvironmentMap map = map_of(9, 5, [](int x, int y) { return (9 * y + x) * Color{1, 1, 1}; });
    // 8 columns and 4 rows have a width. The lookup's angles err by 2.3e-8, which moves a texel of 1/8 turn by 3e-8 and
    // its number, at most 9 a row, by 3e-7.
    const auto shows = [&](double column, double row, double number) {
        return std::fabs(map.bilinear_radiance(towards(column / 8, row / 4)).y - number) < 5e-7;
    };
    CHECK((shows(2.5, 1.5, 9 + 2) && shows(2.75, 1.5, 9 + 2.25) && shows(2.5, 1.75, 9 + 2 + 2.25)));
    CHECK((shows(0, 1.5, 9 + 3.5) && shows(8, 1.5, 9 + 3.5)));  // between columns 7 and 0
    CHECK((shows(2.5, 0.1, 2) && shows(2.5, 3.9, 27 + 2)));     // beyond the centres of the first and last row
    CHECK(same(EnvironmentMap(1, 1, {1, 2, 3}).bilinear_radiance({0, 1, 0}), {1, 2, 3}));
}
