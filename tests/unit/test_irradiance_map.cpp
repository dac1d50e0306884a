#include "known_light/irradiance_map.h"
#include "quadrature/hemisphere.h"
#include "scene/desert.h"

#include "test.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

using portable::pi;

namespace {

std::vector<Vec3> random_normals(std::size_t n) {
    Random random(13, 1);
    std::vector<Vec3> normals = uniform_directions(n, random);
    for (std::size_t i = 0; i < n; i += 2) normals[i].y = -normals[i].y;
    return normals;
}

// Normals of surfaces that the middle of a texel lights at grazing angles, the texel's direction first.
std::vector<Vec3> grazing_normals(int width, int height, int row, int column, std::size_t n) {
    const double polar = pi * (row + 0.5) / (height - 1), azimuth = 2 * pi * ((column + 0.5) / (width - 1) - 0.5);
    const Frame frame({std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)});
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
        const double polar = pi * (row + 0.5) / rows;
        const double solid_angle = 2 * pi / columns * (std::cos(pi * row / rows) - std::cos(pi * (row + 1) / rows));
        for (int column = 0; column < columns; ++column) {
            const double azimuth = 2 * pi * ((column + 0.5) / columns - 0.5);
            const Vec3 w{std::sin(polar) * std::sin(azimuth), std::cos(polar), -std::sin(polar) * std::cos(azimuth)};
            const float* rgb = map.texels() + 3 * (row * map.width() + column);
            const Color light = solid_angle * Color{rgb[0], rgb[1], rgb[2]};
            for (std::size_t i = 0; i < normals.size(); ++i)
                sums[i] = sums[i] + std::max(0.0, dot(w, normals[i])) * light;
        }
    }
    return sums;
}

// The largest error of E over the largest E, any colour.
double worst_error(const EnvironmentMap& map, const std::vector<Vec3>& normals) {
    const IrradianceMap irradiance(map);
    const std::vector<Color> truth = summed_irradiance(map, normals);
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
    std::vector<float> rgb(static_cast<std::size_t>(3 * width * height), 0.5f);
    const double texel = std::sin(pi * (row + 0.5) / (height - 1)) * pi / (height - 1) * 2 * pi / (width - 1);
    for (int i = 0; i < 3; ++i)
        rgb[static_cast<std::size_t>(3 * (row * width + column) + i)] =
            static_cast<float>(0.5 * 4 * pi / texel * times);
    return EnvironmentMap(width, height, rgb);
}

}  // namespace

TEST_CASE("the irradiance of 1000 random normals is within 1e-3 of the largest") {
    CHECK(worst_error(load_environment(), random_normals(1000)) < 1e-3);
}

// Where a point light sets, E has a kink, and interpolation over cells of pi / 64 errs there by up to a quarter of
// them, 1.2e-2 of the light.
TEST_CASE("all the light in one texel of 1024 x 512: the irradiance is within 1.3e-2 of the largest") {
    for (const auto& [row, column] : {std::pair(0, 300), {100, 300}, {200, 511}, {255, 300}, {400, 0}}) {
        const EnvironmentMap map = with_bright_texel(1024, 512, row, column, 100);
        CHECK(worst_error(map, random_normals(50)) < 1.3e-2);
        CHECK(worst_error(map, grazing_normals(1024, 512, row, column, 100)) < 1.3e-2);
    }
}

TEST_CASE("a light whose integrals would exceed the largest float is refused") {
    const auto map = [](float value) { return EnvironmentMap(2, 2, std::vector<float>(12, value)); };
    CHECK_THROWS_AS(IrradianceMap(map(3e38f)), std::runtime_error);
    CHECK(std::isfinite(IrradianceMap(map(1e36f))({0, 1, 0}).x));
}

TEST_CASE("a light of coarse texels: the irradiance is within 1e-3 of the largest") {
    // Summed over the middles of 64 x 64 pieces of each texel.
    std::vector<float> coarse, fine(3 * 577 * 321);
    for (int i = 0; i < 3 * 10 * 6; ++i) coarse.push_back(static_cast<float>(i % 7));
    for (int row = 0; row < 320; ++row)
        for (int column = 0; column < 576; ++column)
            for (int i = 0; i < 3; ++i)
                fine[static_cast<std::size_t>(3 * (row * 577 + column) + i)] =
                    coarse[static_cast<std::size_t>(3 * (row / 64 * 10 + column / 64) + i)];
    const IrradianceMap irradiance(EnvironmentMap(10, 6, coarse));
    const std::vector<Vec3> normals = random_normals(100);
    const std::vector<Color> truth = summed_irradiance(EnvironmentMap(577, 321, fine), normals);
    double largest = 0;
    for (const Color& e : truth) largest = std::max({largest, e.x, e.y, e.z});
    for (std::size_t i = 0; i < normals.size(); ++i) CHECK(length(irradiance(normals[i]) - truth[i]) < 1e-3 * largest);
}

TEST_CASE("a uniform light of radiance L has the irradiance pi L, whatever the size of its map") {
    for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {7, 1}, {2, 2}, {300, 40}, {1024, 512}}) {
        const std::vector<float> rgb(static_cast<std::size_t>(3 * width * height), 0.25f);
        const IrradianceMap irradiance(EnvironmentMap(width, height, rgb));
        for (const Vec3& normal : random_normals(100)) {
            // Cells of the width w = pi / 48 that the horizon cuts lose w^2 / 12 = 3.6e-4 of all light on average.
            CHECK(std::fabs(irradiance(normal).x / (0.25 * pi) - 1) < 5e-4);
            CHECK(irradiance(normal).x == irradiance(normal).z);
        }
    }
}
