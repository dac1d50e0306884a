#include "light/environment.h"
#include "test.h"

TEST_CASE("a direction meets the texel at the floor of column and row") {
    const EnvironmentMap map = coloured_map(512, 256);
    CHECK(map.index({0, 0, -1}) == map.index(255, 127));  // u = 1/2: 255.5, v = 1/2: 127.5
    CHECK(map.index({1, 0, 0}) == map.index(383, 127));   // u = 3/4: 383.25
    CHECK(map.index({-1, 0, 0}) == map.index(127, 127));  // u = 1/4: 127.75
    CHECK(map.index({0, 0, 1}) == map.index(511, 127));
    CHECK(map.index({0, 1, 0}) == map.index(255, 0));  // straight up and down it has the azimuth of -z
    CHECK(map.index({0, -1, 0}) == map.index(255, 255));
}

TEST_CASE("radiance is interpolated between the centres of texels, around the azimuth, too") {
    const EnvironmentMap map = map_of(9, 5, [](int x, int y) { return (9 * y + x) * Colour{1, 1, 1}; });
    // 8 columns and 4 rows have a width. The lookup's angles err by 2.3e-8, which moves a texel of 1/8 turn by 3e-8 and
    // its number, at most 9 a row, by 3e-7.
    const double places[][3] = {{2.5, 1.5, 9 + 2}, {2.75, 1.5, 9 + 2.25}, {2.5, 1.75, 9 + 2 + 2.25},
                                {0, 1.5, 9 + 3.5}, {8, 1.5, 9 + 3.5},    // between columns 7 and 0
                                {2.5, 0.1, 2},     {2.5, 3.9, 27 + 2}};  // beyond the centres of the first and last row
    for (const auto& [column, row, number] : places) {
        const double found = map.bilinear_radiance(towards(column / 8, row / 4)).y, expected = number;
        CHECK_MESSAGE(std::fabs(found - expected) < 5e-7, found << " for " << expected);
    }
    CHECK(even_map(1, 1, 3).bilinear_radiance({0, 1, 0}) == Vec3{3, 3, 3});
}

TEST_CASE("every light with a name is finite and nowhere negative, and not black") {
    for (const std::string& name : light_names()) {
        const EnvironmentMap map = load_environment(name);
        double least = 0, sum = 0;
        for (int i = 1; i <= map.width * map.height; ++i) {
            least = std::min({least, map.colour(i).x, map.colour(i).y, map.colour(i).z});
            sum += dot(map.colour(i), {1, 1, 1});
        }
        CHECK_MESSAGE((least == 0 && sum > 0 && sum < infinity), name);
    }
}

TEST_CASE("the pieces of a map cover the sphere once, each within its texel") {
    for (const auto& [width, height] : {std::pair(1, 1), {9, 5}, {40, 1}}) {
        const EnvironmentMap map = coloured_map(width, height);
        const TexelsOnSphere texels(map, 20, 10);
        CHECK(texels.columns >= 20);
        CHECK(texels.rows >= 10);
        CAPTURE(map.width);
        double all = 0;
        for (int row = 0; row < texels.rows; ++row) {
            all += texels.columns * texels.solid_angle(row);
            for (int column = 0; column < texels.columns; ++column)
                CHECK(texels(row, column) ==
                      map.radiance(direction_of(texels.polar(row + 0.5), texels.azimuth(column + 0.5))));
        }
        CHECK(relative(all, 4 * pi) < 1e-14);
    }
}
