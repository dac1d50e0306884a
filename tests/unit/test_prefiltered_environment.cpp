#include "known_light/prefiltered_environment.h"

#include "test.h"

namespace {

// The mean over caps with their centres in a texel of the table, each centre with its share of the solid angle.
Color direct_mean(const EnvironmentMap& map, const EnvironmentMap& table, double solid_angle, int texel,
                  Random& random) {
    constexpr std::size_t n = 4000;
    Color sum;
    double weights = 0;
    for (const Vec3& w : fibonacci_directions(n)) {
        const double column = texel % table.width() + random.uniform();
        const double row = texel / table.width() + random.uniform();
        const Frame frame(towards(column / (table.width() - 1), row / (table.height() - 1)));
        const double cosine = 1 - (1 - w.y) * solid_angle / (2 * pi), across = std::sqrt(1 - w.y * w.y);
        const double sine = std::sqrt(1 - cosine * cosine);
        const double weight = std::sqrt(1 - frame.normal.y * frame.normal.y);
        sum += weight * map.radiance(frame.to_world(Vec3{sine * w.x / across, cosine, sine * w.z / across}));
        weights += weight;
    }
    return 1 / weights * sum;
}

}  // namespace

// A cap is lookups in caps of a quarter of its size: seven per cent off at worst, at edges.
TEST_CASE("300 random caps of the built-in light have the mean of a direct sum to 1.2 % in root mean square") {
    const PrefilteredEnvironment light(desert);
    Random random(5, 7);
    double worst = 0, squares = 0;
    for (int i = 0; i < 300; ++i) {
        const double solid_angle = pi / (1 << 2 * (i % 6));
        const EnvironmentMap& table = light.means(solid_angle);
        Vec3 w = uniform_directions(1, random)[0];
        if (i % 4 < 2) w.y = -w.y;
        const int texel = table.grid().texel_index(w.x, w.y, w.z);
        const double error = table.texel(texel).y / direct_mean(desert, table, solid_angle, texel, random).y - 1;
        worst = std::max(worst, std::fabs(error));
        squares += error * error / 300;
    }
    INFO(worst, " ", std::sqrt(squares));
    CHECK(worst < 0.07);
    CHECK(std::sqrt(squares) < 0.012);
}

TEST_CASE("a uniform light is its own mean over any cap, whatever the size of its map") {
    for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {7, 1}, {2, 2}, {300, 40}, {1024, 512}}) {
        const EnvironmentMap map = even_map(width, height, 0.25);
        const PrefilteredEnvironment light(map);
        for (int level = 0; level < 5; ++level) {
            double worst = 0;
            for (const float mean : values(light.means(pi / (1 << 2 * level))))
                worst = std::max(worst, std::fabs(mean / 0.25 - 1));
            CHECK(worst < 2e-6);  // the millionth that no cap is without, and rounding to float
        }
    }
}

TEST_CASE("where there is light, no cap is black") {
    // 40 of 1953 texels, small ones: no sun, since their radiance is less than a hundred times the mean.
    const EnvironmentMap map = map_of(64, 32, [](int column, int row) {
        return row == 5 && column >= 10 && column < 50 ? Color{1, 1, 1} : Color{};
    });
    const PrefilteredEnvironment light(map);
    const double down = light.means(pi / 64).radiance({0, -1, 0}).x;
    CHECK(down > 0);
    CHECK(down < 4e-8);  // a millionth of a mean of 0.03
}

TEST_CASE("the table for a solid angle is the one whose ratio to it is nearest to 1; the finest is the map") {
    const PrefilteredEnvironment light(desert);
    const auto same = [&](double a, double b) { return &light.means(a) == &light.means(b); };
    CHECK(same(100, pi));
    CHECK(same(pi / 1.9, pi));
    CHECK(same(pi / 2.1, pi / 4));
    CHECK(!same(pi / 2.1, pi));
    CHECK(same(pi / 1000, pi / 1024));
    CHECK(&light.means(1e-6) == &desert);
    // A texel at the equator has 2 pi / 1023 times pi / 511; the smallest caps have pi / 1024.
    CHECK(&light.means(std::sqrt(3.776e-5 * pi / 1024) * 0.999) == &desert);
    CHECK(&light.means(std::sqrt(3.776e-5 * pi / 1024) * 1.001) == &light.means(pi / 1024));
}
