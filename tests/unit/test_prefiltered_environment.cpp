#include "known_light/prefiltered_environment.h"
#include "quadrature/hemisphere.h"
#include "scene/desert.h"

#include "test.h"

#include <algorithm>
#include <cmath>

using portable::pi;

namespace {

struct Sum {
    Color light;
    double solid_angle = 0;

    void add(double weight, const Sum& other) {
        light = light + weight * other.light;
        solid_angle += weight * other.solid_angle;
    }
};

// Integrals over caps: the part of every row of texels that is nearer to the centre than the radius, by the row's
// middle.
class DirectSums {
public:
    explicit DirectSums(const EnvironmentMap& map) : columns_(map.width() - 1), rows_(map.height() - 1) {
        for (int row = 0; row < rows_; ++row) {
            Color sum;
            for (int column = 0; column <= columns_; ++column) {
                prefix_.push_back(sum);
                const float* rgb = map.texels() + 3 * (row * map.width() + column);
                sum = sum + Color{rgb[0], rgb[1], rgb[2]};
            }
        }
    }

    Sum cap(double polar, double azimuth, double radius) const {
        Sum sum;
        for (int row = 0; row < rows_; ++row) {
            const double at = pi * (row + 0.5) / rows_;
            const double cosine =
                (std::cos(radius) - std::cos(polar) * std::cos(at)) / (std::sin(polar) * std::sin(at));
            if (cosine >= 1) continue;
            const double half = columns_ / (2 * pi) * (cosine <= -1 ? pi : std::acos(cosine));
            const double centre = columns_ * (azimuth / (2 * pi) + 0.5);
            const double texel = 2 * pi / columns_ * (std::cos(pi * row / rows_) - std::cos(pi * (row + 1) / rows_));
            sum.add(texel, {up_to(row, centre + half) - up_to(row, centre - half), 2 * half});
        }
        return sum;
    }

private:
    // The light from column 0 to x, in any turn.
    Color up_to(int row, double x) const {
        const double turns = std::floor(x / columns_), in_turn = x - turns * columns_;
        const int column = std::min(static_cast<int>(in_turn), columns_ - 1);
        const Color* prefix = &prefix_[static_cast<std::size_t>(row * (columns_ + 1))];
        return turns * prefix[columns_] + prefix[column] + (in_turn - column) * (prefix[column + 1] - prefix[column]);
    }

    int columns_, rows_;
    std::vector<Color> prefix_;
};

double cap_radius(const LightTable& table) { return std::acos(1 - table.solid_angle / (2 * pi)); }

int columns_of(const LightTable& table) { return table.columns - 1; }

// The mean over caps with their centres in a texel of the table, each centre with its share of the solid angle.
Color direct_mean(const DirectSums& sums, const LightTable& table, int row, int column) {
    constexpr int n = 6;
    const int columns = columns_of(table);
    Sum mean;
    for (int i = 0; i < n * n; ++i) {
        const double polar = 2 * pi * (row + (i / n + 0.5) / n) / columns;
        const double azimuth = 2 * pi * ((column + (i % n + 0.5) / n) / columns - 0.5);
        mean.add(std::sin(polar), sums.cap(polar, azimuth, cap_radius(table)));
    }
    return 1 / mean.solid_angle * mean.light;
}

}  // namespace

// A cap is lookups in caps of a quarter of its size: seven per cent off at worst, at edges.
TEST_CASE("1000 random caps of the built-in light have the mean of a direct sum to 1.2 % in root mean square") {
    const EnvironmentMap map = load_environment();
    const PrefilteredEnvironment light(map);
    const DirectSums sums(map);
    Random random(5, 7);
    double worst = 0, squares = 0;
    for (int i = 0; i < 1000; ++i) {
        const LightTable& table = light.tables()[static_cast<std::size_t>(i) % (light.tables().size() - 1)];
        Vec3 w = uniform_directions(1, random)[0];
        if (i % 4 < 2) w.y = -w.y;
        const int texel = TexelGrid(table.columns, table.rows).texel_index(w.x, w.y, w.z), width = table.columns;
        const Color mean = direct_mean(sums, table, texel / width, texel % width);
        const double error = table.rgb[3 * texel + 1] / mean.y - 1;
        worst = std::max(worst, std::fabs(error));
        squares += error * error / 1000;
    }
    CAPTURE(worst);
    CAPTURE(std::sqrt(squares));
    CHECK(worst < 0.07);
    CHECK(std::sqrt(squares) < 0.012);
}

TEST_CASE("a uniform light is its own mean over any cap, whatever the size of its map") {
    for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {7, 1}, {2, 2}, {300, 40}, {1024, 512}}) {
        const EnvironmentMap map(width, height,
                                 std::vector<float>(static_cast<std::size_t>(3 * width * height), 0.25f));
        const PrefilteredEnvironment light(map);
        REQUIRE(light.tables().size() > 3);
        for (const LightTable& table : light.tables()) {
            double worst = 0;
            for (int i = 0; &table != &light.tables().back() && i < 3 * table.columns * table.rows; ++i)
                worst = std::max(worst, std::fabs(table.rgb[i] / 0.25 - 1));
            CHECK(worst < 2e-6);  // the millionth that no cap is without, and rounding to float
        }
    }
}

TEST_CASE("where there is light, no cap is black") {
    std::vector<float> rgb(3 * 64 * 32, 0);
    // 40 of 1953 texels, small ones: no sun, since their radiance is less than a hundred times the mean.
    for (std::size_t i = 0; i < 3 * 40; ++i) rgb[3 * (64 * 5 + 10) + i] = 1;
    const EnvironmentMap map(64, 32, rgb);
    const PrefilteredEnvironment light(map);
    const LightTable& finest = light.tables()[light.tables().size() - 2];
    const int down = TexelGrid(finest.columns, finest.rows).texel_index(0.0, -1.0, 0.0);
    CHECK(finest.rgb[3 * down] > 0);
    CHECK(finest.rgb[3 * down] < 4e-8f);  // a millionth of a mean of 0.03
}

TEST_CASE("the table for a solid angle is the one whose ratio to it is nearest to 1; the finest is the map") {
    const EnvironmentMap map = load_environment();
    const PrefilteredEnvironment light(map);
    CHECK(light.table(100).solid_angle == pi);
    CHECK(light.table(pi / 1.9).solid_angle == pi);
    CHECK(light.table(pi / 2.1).solid_angle == pi / 4);
    CHECK(light.table(pi / 1000).solid_angle == pi / 1024);
    CHECK(light.table(1e-6).rgb == map.texels());
    // A texel at the equator: 2 pi / 1023 times pi / 511.
    CHECK(std::fabs(light.tables().back().solid_angle - 3.776e-5) < 1e-8);
}
