#include "beyond/known_light.h"
#include "test.h"

using namespace bmc::beyond;

// The light 1 + w.slope, and beside it the light 1.
static const Vec3 slope{0.48, -0.64, 0.6};
static EnvironmentMap linear_map(int columns, int rows) {
    return map_of(columns + 1, rows + 1, [=](int x, int y) {
        return Colour{1 + dot(towards((x + 0.5) / columns, (y + 0.5) / rows), slope), 1, 0};
    });
}

// A cap of height b around n has the mean 1 + (1 - b / 2) n.slope.
TEST_CASE("the tables hold means over caps, within 2 % of the largest light") {
    const EnvironmentMap map = linear_map(512, 256);
    const PrefilteredEnvironment light(map, 2);
    for (const double solid_angle : {pi, pi / 4, pi / 16, pi / 64}) {
        const EnvironmentMap& means = light.means(solid_angle);
        CAPTURE(solid_angle);
        const int columns = means.width - 1, rows = means.height - 1;
        for (int i = 0; i < columns * rows; ++i) {
            const Vec3 n = towards((i % columns + 0.5) / columns, (i / columns + 0.5) / rows);
            CAPTURE(n);
            CHECK(std::fabs(means.radiance(n).x - (1 + (1 - solid_angle / (4 * pi)) * dot(n, slope))) < 0.04);
            CHECK(relative(means.radiance(n).y, 1) < 2e-6);  // the millionth that no cap is without, and floats
        }
    }
}

TEST_CASE("the table for a solid angle is the nearest one, or the map below ten texels") {
    const EnvironmentMap map = even_map(1024, 512, 1);
    const PrefilteredEnvironment light(map, 2);
    const auto one_table = [&](double a, double b) { return &light.means(a) == &light.means(b); };
    CHECK(one_table(100, pi));
    CHECK(one_table(pi / 1.9, pi));
    CHECK(one_table(pi / 2.1, pi / 4));
    CHECK(!one_table(pi / 2.1, pi));
    // A texel at the equator has 2 pi / 1023 times pi / 511; the smallest caps, ten texels wide, have pi / 1024.
    const double between = std::sqrt(2 * pi / 1023 * pi / 511 * pi / 1024);
    CHECK(&light.means(1e-6) == &map);  // no copy, as there is no sun
    CHECK(one_table(1e-6, between * 0.999));
    CHECK(one_table(between * 1.001, pi / 1024));
    CHECK(!one_table(pi / 1024, pi / 256));
}

// Texels of an eighth of all directions, of less than ten times the mean: no sun.
TEST_CASE("where there is light, no cap is black") {
    const EnvironmentMap map = map_of(65, 33, [](int x, int y) { return (x < 16 && y < 16) * Colour{1, 1, 1}; });
    const double down = PrefilteredEnvironment(map).means(pi / 64).radiance({0, -1, 0}).x;
    CHECK(down > 0);
    CHECK(down < 1.3e-7);  // a millionth of a mean of 0.125
}

// The integral of (1 + w.slope) cos(theta) is pi + (2 pi / 3) n.slope.
TEST_CASE("the irradiance is the integral of L cos(theta) within 1e-3, for any size of map") {
    const EnvironmentMap many = linear_map(300, 150), texel = even_map(1, 1, 1), column = even_map(1, 7, 1);
    const PrefilteredEnvironment linear(many, 2), one_texel(texel), one_column(column);
    std::vector<Vec3> normals = all_around(100);
    normals.insert(normals.end(),
                   {{0, 1, 0}, {0, -1, 0}, {0, 0, 1}, normalize({1e-6, 0, 1}), normalize({-1e-6, 0, 1})});
    for (const Vec3& n : normals) {
        CAPTURE(n);
        CHECK(std::fabs(linear.sky_irradiance(n).x - (pi + 2 * pi / 3 * dot(n, slope))) < 1e-3 * 5 * pi / 3);
        for (const double even :
             {linear.sky_irradiance(n).y, one_texel.sky_irradiance(n).z, one_column.sky_irradiance(n).x})
            CHECK(relative(even, pi) < 1e-3);
    }
}

// In the plane of n and the sun the largest error of a cell is where the sun sets in its middle: a quarter of its
// width, which is at most the diagonal of pi / 128 squared.
TEST_CASE("the irradiance by a small sun is cos(theta) times its light, within 9e-3 of it") {
    const EnvironmentMap map = map_of(257, 129, [](int x, int y) { return (x == 70 && y == 40) * Colour{3, 2, 1}; });
    const PrefilteredEnvironment light(map, 2);
    const Vec3 sun = towards(70.5 / 256, 40.5 / 128);
    for (const Vec3& n : all_around(500))
        for (const Vec3& normal : {n, normalize(n - dot(n, sun) * sun)})
            CHECK(std::fabs(light.sun_irradiance(normal).x - std::max(0.0, dot(normal, sun)) * light.sun.light() / 2) <
                  9e-3 * light.sun.light() / 2);
}
