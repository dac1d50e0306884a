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
        std::vector<Vec3> directions;
        for (int i = 0; i < columns; ++i) directions.push_back(towards((i + 0.5) / columns, (row + 0.5) / rows));
        for (std::size_t i = 0; i < normals.size(); ++i) {
            Color sum;
            for (int column = 0; column < columns; ++column)
                if (const double cosine = dot(directions[static_cast<std::size_t>(column)], normals[i]); cosine > 0)
                    sum += cosine * map.texel(row * map.width() + column);
            sums[i] += solid_angle * sum;
        }
    }
    return sums;
}

// The largest error of E over the largest E, any colour.
double worst_error(const EnvironmentMap& map, const std::vector<Vec3>& normals, const std::vector<Color>& truth) {
    const IrradianceMap irradiance(map);
    double error = 0, largest = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Color e = irradiance(normals[i]) - truth[i];
        error = std::max({error, std::fabs(e.x), std::fabs(e.y), std::fabs(e.z)});
        largest = std::max({largest, truth[i].x, truth[i].y, truth[i].z});
    }
    return error / largest;
}

}  // namespace

TEST_CASE("the irradiance of 250 random normals is within 6e-4 of the largest") {
    const std::vector<Vec3> normals = random_normals(250);
    CHECK(worst_error(desert, normals, summed_irradiance(desert, normals)) < 6e-4);
}

// Where a point light sets, E has a kink, and interpolation over cells of pi / 64 errs there by up to a quarter of
// them, 1.2e-2 of the light.
TEST_CASE("all the light in one texel of 1024 x 512: the irradiance is within 1.3e-2 of the largest") {
    for (const auto& [row, column] : {std::pair(0, 300), {100, 300}, {200, 511}, {255, 300}, {400, 0}}) {
        // It sends 100 times as much as all the others, of the radiance 1, together.
        const double solid_angle = std::sin(pi * (row + 0.5) / 511) * pi / 511 * 2 * pi / 1023, light = 400 * pi;
        const EnvironmentMap map = map_of(1024, 512, [&, row = row, column = column](int x, int y) {
            return (x == column && y == row ? 1 + light / solid_angle : 1) * Color{1, 1, 1};
        });
        std::vector<Vec3> normals = grazing_normals(map, row, column, 1000);
        for (const Vec3& normal : random_normals(1000)) normals.push_back(normal);
        std::vector<Color> truth;
        for (const Vec3& normal : normals)
            truth.push_back((pi + light * std::max(0.0, dot(normal, normals[0]))) * Color{1, 1, 1});
        CHECK(worst_error(map, normals, truth) < 1.3e-2);
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
    const std::vector<Vec3> normals = random_normals(100);
    CHECK(worst_error(coarse, normals, summed_irradiance(fine, normals)) < 1e-3);
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
