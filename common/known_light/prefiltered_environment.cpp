#include "known_light/prefiltered_environment.h"

#include "known_light/texels_on_sphere.h"
#include "quadrature/hemisphere.h"
#include "scene/parallel.h"

namespace bmc {
namespace {

using portable::pi;

constexpr std::size_t lookups = 64;  // that a mean is made of

// Directions spread evenly over the inner three quarters of a cap around the up axis. The smaller caps around them
// reach to the cap's edge.
std::vector<Direction> cap_directions(double solid_angle) {
    const double depth = 0.75 * solid_angle / (2 * pi);  // 1 less the cosine of the radius
    std::vector<Direction> directions;
    for (const Vec3& direction : fibonacci_directions(lookups)) {
        const double cosine = 1 - depth * (1 - direction.y);
        const double scale = std::sqrt((1 - cosine * cosine) / (1 - direction.y * direction.y));
        directions.emplace_back(Vec3{scale * direction.x, cosine, scale * direction.z});
    }
    return directions;
}

}  // namespace

void Caps::add(const LightTable& table) {
    columns.push_back(table.columns);
    rows.push_back(table.rows);
    rgb.push_back(table.rgb);
}

Color Caps::radiance(std::size_t i, Direction direction) const {
    const int texel = TexelGrid(columns[i], rows[i]).texel_index(direction.x, direction.y, direction.z);
    const float* light = rgb[i] + 3 * std::ptrdiff_t{texel};
    return {light[0], light[1], light[2]};
}

PrefilteredEnvironment::PrefilteredEnvironment(const EnvironmentMap& map, unsigned threads)
    : sun_(map),
      without_sun_(sun_.empty() ? std::nullopt : std::optional(sun_.keep(Sun::Part::sky))),
      sky_(without_sun_ ? *without_sun_ : map),
      irradiance_(sky_, threads) {
    if (!sun_.empty()) sun_irradiance_.emplace(sun_.keep(Sun::Part::sun), threads);
    const TexelsOnSphere texels(sky_, 256, 128);
    tables_ = {{texels.solid_angle(texels.rows() / 2), sky_.width(), sky_.height(), sky_.texels()}};
    double smallest = pi;
    while (std::sqrt(smallest / pi) >= 10 * pi / texels.rows()) smallest /= 4;
    for (double solid_angle = smallest; solid_angle <= pi; solid_angle *= 4)
        tables_.insert(tables_.begin(), average(tables_[0], solid_angle, threads));
}

// A cap is made of caps of a quarter of its size, the smallest one of texels: each texel of the table is the mean of
// lookups in the finer table. Only u = 1 and v = 1 meet the last row and column, which repeat their neighbours.
LightTable PrefilteredEnvironment::average(const LightTable& finer, double solid_angle, unsigned threads) {
    const int rows = 1 + static_cast<int>(1.5 * pi / std::sqrt(solid_angle / pi)), columns = 2 * rows;
    const std::vector<Direction> local = cap_directions(solid_angle);
    const Color light = sky_irradiance({0, 1, 0}) + sky_irradiance({0, -1, 0});
    const bool is_map = finer.rgb == sky_.texels();
    const Color everywhere = is_map ? 1e-6 / (2 * pi) * light : Color{};
    const TexelGrid grid(finer.columns, finer.rows);
    std::vector<float> rgb(3 * static_cast<std::size_t>((rows + 1) * (columns + 1)) + EnvironmentMap::padding);
    const auto row = [&](int y) {
        const portable::SineCosine polar = portable::sincos_turns(0.5 * (std::min(y, rows - 1) + 0.5) / rows);
        for (int x = 0; x <= columns; ++x) {
            const auto azimuth = portable::sincos_turns((std::min(x, columns - 1) + 0.5) / columns - 0.5);
            const Frame frame(direction_of(polar, azimuth));
            int texels[lookups];
            for (std::size_t i = 0; i < lookups; ++i) {
                const Direction direction = frame.to_world(local[i]);
                texels[i] = 3 * grid.texel_index(direction.x, direction.y, direction.z);
            }
            Color sum;
            for (std::size_t i = 0; i < lookups; ++i) {
                const float* seen = finer.rgb + texels[i];
                sum += Color{seen[0], seen[1], seen[2]};
            }
            const Color mean = 1.0 / lookups * sum + everywhere;
            float* texel = &rgb[3 * static_cast<std::size_t>(y * (columns + 1) + x)];
            texel[0] = static_cast<float>(mean.x);
            texel[1] = static_cast<float>(mean.y);
            texel[2] = static_cast<float>(mean.z);
        }
    };
    for_each_row(rows + 1, threads, row);
    averages_.push_back(std::move(rgb));
    return {solid_angle, columns + 1, rows + 1, averages_.back().data()};
}

const LightTable& PrefilteredEnvironment::table(double solid_angle) const {
    std::size_t i = 0;
    while (i + 1 < tables_.size() && solid_angle * solid_angle < tables_[i].solid_angle * tables_[i + 1].solid_angle)
        ++i;
    return tables_[i];
}
}  // namespace bmc
