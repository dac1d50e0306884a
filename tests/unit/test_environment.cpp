#include "light/environment.h"

#include "test.h"

namespace {

// Texel i of the map has the radiance (i, i, i).
EnvironmentMap numbered_map(int width, int height) {
    return map_of(width, height, [&](int column, int row) { return (row * width + column) * Color{1, 1, 1}; });
}

std::string construction_error(int width, int height, const std::vector<float>& rgb) {
    return message_of([&] { EnvironmentMap(width, height, rgb); });
}

}  // namespace

TEST_CASE("an environment map refuses sizes that do not match its values, and values that are no radiances") {
    CHECK(contains(construction_error(2, 2, {1, 2, 3}), "2 x 2 texels with 3 values"));
    CHECK(contains(construction_error(-1, -1, {1, 2, 3}), "-1 x -1"));
    CHECK(contains(construction_error(65536, 65536, {}), "65536 x 65536"));
    CHECK(contains(construction_error(std::numeric_limits<int>::min(), 1, {}), "it takes 1 to 67108864"));
    for (const double value : {-0.5, infinity, -infinity, nan_value}) {
        std::vector<float> rgb(3 * 4 * 3, 0.25f);
        rgb[29] = static_cast<float>(value);
        CHECK(contains(construction_error(4, 3, rgb), formatted("environment map: %.9g is not", value)));
    }
}

// The arctangent and the arccosine err by at most 2e-8, so columns and rows by 3.3e-6: that is the probability with
// which a border separates a random direction from its texel. Among 1e6 at most 7 are expected, and 30 are eight
// standard deviations more. In single precision an angle is off by some 5e-8 more: 50 to 100 are expected.
TEST_CASE("the texel of a direction is that of atan2 and acos, but for a few neighbours in a million") {
    const TexelGrid grid(1024, 512);
    int different = 0, different_in_single = 0, not_neighbours = 0;
    for (const Vec3& d : random_normals(1000000)) {
        const int column = static_cast<int>((1 + std::atan2(d.x, -d.z) / pi) / 2 * 1023);
        const int row = static_cast<int>(std::acos(d.y) / pi * 511);
        const auto distance = [&](int index) { return std::abs(index % 1024 - column) + std::abs(index / 1024 - row); };
        const int off = distance(grid.texel_index(d.x, d.y, d.z));
        const Direction single(d);
        const int off_in_single = distance(grid.texel_index(single.x, single.y, single.z));
        different += off != 0;
        different_in_single += off_in_single != 0;
        not_neighbours += off > 1 || off_in_single > 1;
    }
    CHECK(different <= 30);
    CHECK(different_in_single <= 150);
    CHECK(not_neighbours == 0);
}

TEST_CASE("the axes meet the texels of the definition") {
    const EnvironmentMap map = numbered_map(512, 256);
    const auto texel = [](int column, int row) { return row * 512 + column; };
    CHECK(map.radiance({0, 0, -1}).x == texel(255, 127));  // u = 1/2: floor(255.5), v = 1/2: floor(127.5)
    CHECK(map.radiance({1, 0, 0}).x == texel(383, 127));   // u = 3/4: floor(383.25)
    CHECK(map.radiance({-1, 0, 0}).x == texel(127, 127));  // u = 1/4: floor(127.75)
    CHECK(map.radiance({0, 0, 1}).x == texel(511, 127));   // u = 1
    CHECK(map.radiance({0, 1, 0}).x == texel(255, 0));     // v = 0
    CHECK(map.radiance({0, -1, 0}).x == texel(255, 255));  // v = 1
}

TEST_CASE("every direction has a texel of the map, also one that is no unit vector or no direction at all") {
    const std::vector<double> coordinates = {0.0,    -0.0,   1,     -1,     1 + 1e-15, -1 - 1e-15, 1 - 1e-15,
                                             5e-324, 1e-200, 1e300, -1e300, infinity,  -infinity,  nan_value};
    for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {7, 1}, {512, 256}}) {
        const TexelGrid grid(width, height);
        int outside = 0;
        for (const double x : coordinates)
            for (const double y : coordinates)
                for (const double z : coordinates) {
                    const Direction d(Vec3{x, y, z});
                    for (const int index : {grid.texel_index(x, y, z), grid.texel_index(d.x, d.y, d.z)})
                        outside += index < 0 || index >= width * height;
                }
        CHECK(outside == 0);
    }
}

TEST_CASE("in a map of 67 million columns or rows, too, every direction has a texel") {
    constexpr int many = (1 << 26) - 1;
    for (const float z : {1.0f, -1.0f})
        for (const float x : {0.0f, 1e-9f, -1e-9f}) {
            CHECK(TexelGrid(many, 1).texel_index(x, 0.0f, z) < many);
            CHECK(TexelGrid(1, many).texel_index(x, z, 0.0f) < many);
            CHECK(TexelGrid(many, 1).texel_index(x, 0.0f, z) >= 0);
        }
}

TEST_CASE("interpolated radiance is the texel's at its centre, the mean half-way, and closed around the azimuth") {
    const EnvironmentMap map = numbered_map(9, 5);  // 8 columns and 4 rows with a width
    // The lookup's angles err by 2.3e-8, which moves a texel of 1/8 turn by 3e-8 and its number, at most 9 a row, by
    // 3e-7.
    const auto shows = [&](double column, double row, double number) {
        return std::fabs(map.interpolated_radiance(towards(column / 8, row / 4)).y - number) < 5e-7;
    };
    CHECK(shows(2.5, 1.5, 9 + 2));
    CHECK(shows(3, 1.5, 9 + 2.5));
    CHECK(shows(2.5, 2, (9 + 2 + 18 + 2) / 2.0));
    CHECK(shows(0, 1.5, 9 + 3.5));  // between columns 7 and 0
    CHECK(shows(8, 1.5, 9 + 3.5));
    CHECK(shows(2.5, 0.1, 2));  // above the centres of the first row
    CHECK(shows(2.5, 3.9, 27 + 2));
    const Color one = EnvironmentMap(1, 1, {1, 2, 3}).interpolated_radiance({0, 1, 0});
    CHECK(one.x == 1);
    CHECK(one.z == 3);
}
