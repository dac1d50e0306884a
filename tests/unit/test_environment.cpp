#include "numerics/random.h"
#include "scene/environment.h"

#include "test.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

Vec3 random_direction(Random& random) {
    const double height = 2 * random.uniform() - 1;
    const double angle = 2 * portable::pi * random.uniform();
    const double radius = std::sqrt(1 - height * height);
    return {radius * std::cos(angle), height, radius * std::sin(angle)};
}

// Texel i of the map has the radiance (i, i, i).
EnvironmentMap numbered_map(int width, int height) {
    std::vector<float> rgb;
    for (int i = 0; i < 3 * width * height; ++i) rgb.push_back(static_cast<float>(i / 3));
    return EnvironmentMap(width, height, rgb);
}

std::string construction_error(int width, int height, std::vector<float> rgb) {
    try {
        EnvironmentMap(width, height, std::move(rgb));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("an environment map returns the texels that it was given") {
    const EnvironmentMap map(2, 1, {1, 2, 3, 4, 5, 6});
    CHECK(map.width() == 2);
    CHECK(map.height() == 1);
    CHECK(std::vector<float>(map.texels(), map.texels() + 6) == std::vector<float>{1, 2, 3, 4, 5, 6});
    const Color ahead = map.radiance({0, 0, -1});
    CHECK(ahead.x == 1);
    CHECK(ahead.y == 2);
    CHECK(ahead.z == 3);
}

TEST_CASE("an environment map refuses sizes that do not match its values") {
    CHECK(contains(construction_error(2, 2, {1, 2, 3}), "2 x 2 texels with 3 values"));
    CHECK(contains(construction_error(0, 1, {}), "0 x 1"));
    CHECK(contains(construction_error(-1, -1, {1, 2, 3}), "-1 x -1"));
    CHECK(contains(construction_error(65536, 65536, {}), "65536 x 65536"));
    CHECK(contains(construction_error(std::numeric_limits<int>::min(), 1, {}), "it takes 1 to 67108864"));
}

TEST_CASE("an environment map names the value of a texel that is not a radiance") {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {-0.5f, infinity, -infinity, std::numeric_limits<float>::quiet_NaN()}) {
        std::vector<float> rgb(3 * 4 * 3, 0.25f);
        rgb[3 * (2 * 4 + 1) + 2] = bad;
        const std::string error = construction_error(4, 3, rgb);
        CAPTURE(error);
        CHECK(contains(error, std::to_string(bad) + " is not"));
    }
}

// The arctangent and the arccosine err by at most 2e-8, so u (W - 1) by 2e-8 / (2 pi) * 1023 = 3.3e-6 and v (H - 1) by
// 2e-8 / pi * 511 = 3.3e-6. One border per column and per row moves by that, and it separates a random direction from
// its texel with that probability: among 1e6 at most 7 are expected, and 30 are eight standard deviations more. In
// single precision a component is off by 3e-8 at most, an angle by some 5e-8, and a column of up to 1023 by 3e-5 more:
// 50 to 100 are expected.
TEST_CASE("the texel of a direction is that of atan2 and acos, but for a few neighbours in a million") {
    const EnvironmentMap map(1024, 512, std::vector<float>(3 * 1024 * 512, 1.0f));
    Random random(20240229, 1);
    int different = 0, different_in_single = 0, not_neighbours = 0;
    for (int i = 0; i < 1000000; ++i) {
        const Vec3 d = random_direction(random);
        const int column = static_cast<int>((1 + std::atan2(d.x, -d.z) / portable::pi) / 2 * 1023);
        const int row = static_cast<int>(std::acos(d.y) / portable::pi * 511);
        const auto distance = [&](int index) { return std::abs(index % 1024 - column) + std::abs(index / 1024 - row); };
        const int off = distance(map.grid().texel_index(d.x, d.y, d.z));
        const int off_in_single =
            distance(map.grid().texel_index(static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)));
        different += off != 0;
        different_in_single += off_in_single != 0;
        not_neighbours += off > 1 || off_in_single > 1;
    }
    MESSAGE(different << " of 1000000 directions meet a neighbour of the exact texel, " << different_in_single
                      << " in single precision");
    CHECK(different <= 30);
    CHECK(different_in_single <= 150);
    CHECK(not_neighbours == 0);
}

TEST_CASE("the axes meet the texels of the definition") {
    const EnvironmentMap map = numbered_map(512, 256);
    const auto texel = [](int column, int row) { return row * 512 + column; };
    CHECK(map.grid().texel_index(0.0, 0.0, -1.0) == texel(255, 127));  // u = 1/2: floor(255.5), v = 1/2: floor(127.5)
    CHECK(map.grid().texel_index(1.0, 0.0, 0.0) == texel(383, 127));   // u = 3/4: floor(383.25)
    CHECK(map.grid().texel_index(-1.0, 0.0, 0.0) == texel(127, 127));  // u = 1/4: floor(127.75)
    CHECK(map.grid().texel_index(0.0, 0.0, 1.0) == texel(511, 127));   // u = 1
    CHECK(map.grid().texel_index(0.0, 1.0, 0.0) == texel(255, 0));     // v = 0
    CHECK(map.grid().texel_index(0.0, -1.0, 0.0) == texel(255, 255));  // v = 1
    CHECK(map.radiance({1, 0, 0}).x == texel(383, 127));
}

TEST_CASE("every direction meets a texel of the map, off unit length and without meaning too") {
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<double> coordinates = {
        0.0,    -0.0,    1,      -1,    1 + 1e-15, -1 - 1e-15, 1 - 1e-15, 1 + 2.3e-16, -1 - 2.3e-16,
        5e-324, -5e-324, 1e-200, 1e300, -1e300,    infinity,   -infinity, nan};
    for (const auto& size : {std::pair<int, int>{1, 1}, {1, 7}, {7, 1}, {512, 256}}) {
        const EnvironmentMap map = numbered_map(size.first, size.second);
        bool inside = true;
        for (const double x : coordinates)
            for (const double y : coordinates)
                for (const double z : coordinates) {
                    const int index = map.grid().texel_index(x, y, z);
                    const int in_single =
                        map.grid().texel_index(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
                    const int texels = size.first * size.second;
                    inside = inside && index >= 0 && index < texels && in_single >= 0 && in_single < texels;
                }
        CHECK(inside);
    }
}

TEST_CASE("a map of more columns or rows than single precision can count has the texels that it finds") {
    constexpr int many = (1 << 26) - 1;
    for (const float z : {1.0f, -1.0f})
        for (const float x : {0.0f, 1e-9f, -1e-9f}) {
            CHECK(TexelGrid(many, 1).texel_index(x, 0.0f, z) < many);
            CHECK(TexelGrid(1, many).texel_index(x, z, 0.0f) < many);
            CHECK(TexelGrid(many, 1).texel_index(x, 0.0f, z) >= 0);
        }
}

TEST_CASE("the lookup gives the same texels in a vectorised loop as one by one") {
    const EnvironmentMap map = numbered_map(64, 32);
    Random random(3, 4);
    std::vector<double> x, y, z;
    for (int i = 0; i < 1003; ++i) {
        const Vec3 d = random_direction(random);
        x.push_back(d.x), y.push_back(d.y), z.push_back(d.z);
    }
    std::vector<int> index(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) index[i] = map.grid().texel_index(x[i], y[i], z[i]);
    bool same = true;
    for (std::size_t i = 0; i < x.size(); ++i) same = same && map.radiance({x[i], y[i], z[i]}).x == index[i];
    CHECK(same);
}

TEST_CASE("interpolated radiance is the texel's at its centre, the mean half-way, and closed around the azimuth") {
    const EnvironmentMap map = numbered_map(9, 5);  // 8 columns and 4 rows with a width
    const auto towards = [](double column, double row) {
        const double azimuth = (column / 8 - 0.5) * 2 * portable::pi, polar = row / 4 * portable::pi;
        return Vec3{std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)};
    };
    // The lookup's angles err by 2.3e-8, which moves a texel of 1/8 turn by 3e-8 and its number, at most 9 a row, by
    // 3e-7.
    const auto near = [](double a, double b) { return std::fabs(a - b) < 5e-7; };
    CHECK(near(map.interpolated_radiance(towards(2.5, 1.5)).x, 9 + 2));
    CHECK(near(map.interpolated_radiance(towards(3, 1.5)).y, 9 + 2.5));
    CHECK(near(map.interpolated_radiance(towards(2.5, 2)).z, (9 + 2 + 18 + 2) / 2.0));
    CHECK(near(map.interpolated_radiance(towards(0, 1.5)).x, 9 + 3.5));  // between columns 7 and 0
    CHECK(near(map.interpolated_radiance(towards(8, 1.5)).x, 9 + 3.5));
    CHECK(near(map.interpolated_radiance(towards(2.5, 0.1)).x, 2));  // above the centres of the first row
    CHECK(near(map.interpolated_radiance(towards(2.5, 3.9)).x, 27 + 2));
    const Color one = EnvironmentMap(1, 1, {1, 2, 3}).interpolated_radiance({0, 1, 0});
    CHECK(one.x == 1);
    CHECK(one.z == 3);
}
