#include "known_light/irradiance_map.h"

#include "test.h"

namespace {

// Normals of surfaces that the middle of a texel lights at grazing angles, the texel's direction first.
std::vector<Vec3> grazing_normals(const EnvironmentMap& map, int row, int column, std::size_t n) {
    const Frame frame(towards((column + 0.5) / (map.width() - 1), (row + 0.5) / (map.height() - 1)));
    Random random(13, 2);
    std::vector<Vec3> normals = {frame.normal};
    while (normals.size() < n) {
        const double elevation = 0.04 * (2 * random.uniform() - 1), turns = random.uniform();
        normals.push_back(frame.to_world(rotate_around_y({std::cos(elevation), std::sin(elevation), 0}, turns)));
    }
    return normals;
}

// E by a sum over the middles of all texels.
std::vector<Color> summed_irradiance(const EnvironmentMap& map, const std::vector<Vec3>& normals) {
    std::vector<Color> sums(normals.size());
    const int columns = map.width() - 1, rows = map.height() - 1;
    for (int row = 0; row < rows; ++row) {
        const double solid_angle = 2 * pi / columns * (std::cos(pi * row / rows) - std::cos(pi * (row + 1) / rows));
        for (int column = 0; column < columns; ++column) {
            const Vec3 w = towards((column + 0.5) / columns, (row + 0.5) / rows);
            const Color light = solid_angle * map.texel(row * map.width() + column);
            for (std::size_t i = 0; i < normals.size(); ++i) sums[i] += std::max(0.0, dot(w, normals[i])) * light;
        }
    }
    return sums;
}

// The largest error of E over the largest E, any colour. The truth is summed over a map of the same light.
double worst_error(const EnvironmentMap& map, const std::vector<Vec3>& normals, const EnvironmentMap& same_light) {
    const IrradianceMap irradiance(map);
    const std::vector<Color> truth = summed_irradiance(same_light, normals);
    double error = 0, largest = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Color e = irradiance(normals[i]) - truth[i];
        error = std::max({error, std::fabs(e.x), std::fabs(e.y), std::fabs(e.z)});
        largest = std::max({largest, truth[i].x, truth[i].y, truth[i].z});
    }
    return error / largest;
}

// A grey map with a texel that sends light, times as much as all the others together.
EnvironmentMap with_bright_texel(int width, int height, int row, int column, double times) {
    const double texel = std::sin(pi * (row + 0.5) / (height - 1)) * pi / (height - 1) * 2 * pi / (width - 1);
    return map_of(width, height, [&](int x, int y) {
        return 0.5 * (x == column && y == row ? 4 * pi / texel * times : 1) * Color{1, 1, 1};
    });
}

}  // namespace

TEST_CASE("the irradiance of 1000 random normals is within 1e-3 of the largest") {
    CHECK(worst_error(desert, random_normals(1000), desert) < 1e-3);
}

// Where a point light sets, E has a kink, and interpolation over cells of pi / 64 errs there by up to a quarter of
// them, 1.2e-2 of the light.
TEST_CASE("all the light in one texel of 1024 x 512: the irradiance is within 1.3e-2 of the largest") {
    for (const auto& [row, column] : {std::pair(0, 300), {100, 300}, {200, 511}, {255, 300}, {400, 0}}) {
        const EnvironmentMap map = with_bright_texel(1024, 512, row, column, 100);
        CHECK(worst_error(map, random_normals(50), map) < 1.3e-2);
        CHECK(worst_error(map, grazing_normals(map, row, column, 100), map) < 1.3e-2);
    }
}

TEST_CASE("a light whose integrals would exceed the largest float is refused") {
    CHECK_THROWS_AS(IrradianceMap(even_map(2, 2, 3e38)), std::runtime_error);
    const EnvironmentMap bright_centre = map_of(3, 3, [](int x, int y) {
        return (x == 1 && y == 1 ? 3e38 : 1.0) * Color{1, 1, 1};
    });
    CHECK_THROWS_AS(IrradianceMap{bright_centre}, std::runtime_error);
    CHECK(std::isfinite(IrradianceMap(even_map(2, 2, 1e36))({0, 1, 0}).x));
}

TEST_CASE("a light of coarse texels: the irradiance is within 1e-3 of the largest") {
    // Summed over the middles of 64 x 64 pieces of each texel.
    const EnvironmentMap coarse = striped_map(10, 6), fine = map_of(577, 321, [&](int column, int row) {
                                                          return coarse.texel(row / 64 * 10 + column / 64);
                                                      });
    CHECK(worst_error(coarse, random_normals(100), fine) < 1e-3);
}

TEST_CASE("a uniform light of radiance L has the irradiance pi L, whatever the size of its map") {
    for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {7, 1}, {2, 2}, {300, 40}, {1024, 512}}) {
        const IrradianceMap irradiance(even_map(width, height, 0.25));
        for (const Vec3& normal : random_normals(100)) {
            // Cells of the width w = pi / 48 that the horizon cuts lose w^2 / 12 = 3.6e-4 of all light on average.
            CHECK(std::fabs(irradiance(normal).x / (0.25 * pi) - 1) < 5e-4);
            CHECK(irradiance(normal).x == irradiance(normal).z);
        }
    }
}
