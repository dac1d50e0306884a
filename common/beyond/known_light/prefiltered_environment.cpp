#include "beyond/known_light/prefiltered_environment.h"

#include "beyond/known_light/texels_on_sphere.h"
#include "numerics/work.h"
#include "quadrature/hemisphere.h"

#include <stdexcept>

namespace bmc::beyond {
namespace {

using portable::pi;

constexpr std::size_t lookups = 32;  // per mean

// Directions spread evenly over the inner three quarters of a cap around the up axis. The smaller caps around them
// reach to the cap's edge.
std::vector<Vec3> cap_directions(double solid_angle) {
    const double depth = 0.75 * solid_angle / (2 * pi);  // 1 less the cosine of the radius
    std::vector<Vec3> directions;
    for (const Vec3& direction : fibonacci_directions(lookups)) {
        const double cosine = 1 - depth * (1 - direction.y);
        const double scale = std::sqrt((1 - cosine * cosine) / (1 - direction.y * direction.y));
        directions.push_back({scale * direction.x, cosine, scale * direction.z});
    }
    return directions;
}

// Beyond 1e36 integrals would exceed the largest float.
const EnvironmentMap& not_too_bright(const EnvironmentMap& map) {
    for (int i = 1; i <= map.width() * map.height(); ++i)
        if (dot(map.color(i), {1, 1, 1}) > 1e36)
            throw std::runtime_error("this light is too bright to be known: a radiance exceeds 1e36");
    return map;
}

}  // namespace

PrefilteredEnvironment::PrefilteredEnvironment(const EnvironmentMap& map, std::size_t threads)
    : sun_(not_too_bright(map)),
      without_sun_(sun_.empty() ? std::nullopt : std::optional(sun_.sky())),
      sky_(without_sun_ ? *without_sun_ : map),
      irradiance_(sky_, threads) {
    const TexelsOnSphere texels(sky_, 256, 128);
    texel_ = texels.solid_angle(texels.rows() / 2);
    double smallest = pi;
    while (std::sqrt(smallest / pi) >= 10 * pi / texels.rows()) smallest /= 4;
    for (double solid_angle = smallest; solid_angle <= pi; solid_angle *= 4)
        tables_.push_back({solid_angle, average(tables_.empty() ? sky_ : tables_.back().means, solid_angle, threads)});
}

// A cap is made of caps of a quarter of its size, the smallest one of texels: each texel of the table is the mean of
// lookups in the finer table. Only u = 1 and v = 1 meet the last row and column, which repeat their neighbours.
EnvironmentMap PrefilteredEnvironment::average(const EnvironmentMap& finer, double solid_angle,
                                               std::size_t threads) const {
    const int rows = 1 + static_cast<int>(1.5 * pi / std::sqrt(solid_angle / pi)), columns = 2 * rows;
    const std::vector<Vec3> local = cap_directions(solid_angle);
    const Color light = sky_irradiance({0, 1, 0}) + sky_irradiance({0, -1, 0});
    const Color everywhere = &finer == &sky_ ? 1e-6 / (2 * pi) * light : Color{};
    EnvironmentMap means(columns + 1, rows + 1);
    const auto row = [&](int y) {
        const portable::SineCosine polar = portable::sincos_turns(0.5 * (std::min(y, rows - 1) + 0.5) / rows);
        for (int x = 0; x <= columns; ++x) {
            const auto azimuth = portable::sincos_turns((std::min(x, columns - 1) + 0.5) / columns - 0.5);
            const Frame frame(direction_of(polar, azimuth));
            int texels[lookups];
            for (std::size_t i = 0; i < lookups; ++i) texels[i] = finer.index(frame.to_world(local[i]));
            Color sum;
            for (const int texel : texels) sum += finer.color(texel);
            means.set(x, y, 1.0 / lookups * sum + everywhere);
        }
    };
    for_each_row(rows + 1, threads, row);
    return means;
}

const EnvironmentMap& PrefilteredEnvironment::means(double solid_angle) const {
    double smaller = texel_;
    const EnvironmentMap* nearest = &sky_;
    for (const Table& table : tables_) {
        if (solid_angle * solid_angle >= smaller * table.solid_angle) nearest = &table.means;
        smaller = table.solid_angle;
    }
    return *nearest;
}
}  // namespace bmc::beyond
