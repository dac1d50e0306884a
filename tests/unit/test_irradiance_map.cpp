#include "known_light/prefiltered_environment.h"

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
    const PrefilteredEnvironment light(map);
    double error = 0, largest = 0;
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const Color e = light.irradiance(normals[i]) - truth[i];
        error = std::max({error, std::fabs(e.x), std::fabs(e.y), std::fabs(e.z)});
        largest = std::max({largest, truth[i].x, truth[i].y, truth[i].z});
    }
    return error / largest;
}

}  // namespace

TEST_CASE("the irradiance of 250 random normals is within 6e-4 of the largest under each built-in light") {
    const std::vector<Vec3> normals = random_normals(250);
    for (const char* name : built_in_lights) {
        const EnvironmentMap map = load_environment(name);
        CHECK(worst_error(map, normals, summed_irradiance(map, normals)) < 6e-4);
    }
}

// They are suns. Where one sets, the horizon cuts the parts that its 256 rays stand for.
TEST_CASE("the light of a lamp of 1 to 20 degrees, anywhere: the irradiance is within 2e-3 of the largest") {
    for (const auto& [degrees, u, v] :
         {std::tuple(1.0, 0.3, 0.35), {1.0, 0.0, 0.5}, {3.0, 0.3, 0.0}, {6.0, 1.0, 0.8}, {20.0, 0.3, 0.35}}) {
        const double cosine = std::cos(pi / 360 * degrees);
        const Vec3 middle = towards(u, v);
        const EnvironmentMap map = map_of(1024, 512, [&](int column, int row) {
            return dot(towards((column + 0.5) / 1023, (row + 0.5) / 511), middle) > cosine ? Color{1, 1, 1} : Color{};
        });
        const std::vector<Vec3> normals =
            grazing_normals(map, static_cast<int>(v * 511), static_cast<int>(u * 1023), 60);
        const double error = worst_error(map, normals, summed_irradiance(map, normals));
        CAPTURE(error);
        CHECK(error < 2e-3);
    }
}

TEST_CASE("a light whose integrals would exceed the largest float is refused") {
    CHECK_THROWS_AS(PrefilteredEnvironment(even_map(2, 2, 3e38)), std::runtime_error);
    const EnvironmentMap bright_centre = map_of(3, 3, [](int x, int y) {
        return (x == 1 && y == 1 ? 3e38 : 1.0) * Color{1, 1, 1};
    });
    CHECK_THROWS_AS(PrefilteredEnvironment{bright_centre}, std::runtime_error);
    const EnvironmentMap bright = even_map(2, 2, 1e36);
    CHECK(std::isfinite(PrefilteredEnvironment(bright).irradiance({0, 1, 0}).x));
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

// The normal (0, 0, 1) is where the table's columns end.
TEST_CASE("the irradiance is continuous across the table's edges, under maps of odd and even widths") {
    for (const int width : {10, 11}) {
        const IrradianceMap irradiance(striped_map(width, 6));
        for (const Vec3 normal : {Vec3{0, 0, 1}, Vec3{0, 1, 0}, Vec3{0, -1, 0}}) {
            const double here = irradiance(normal).x;
            for (const double x : {1e-6, -1e-6})
                CHECK(relative(irradiance(normalize(normal + Vec3{x, 0, 0})).x, here) < 1e-5);
        }
    }
}
