// Means of an environment over caps of several sizes, as tables: a ray that stands for a cap of directions sees them.
// Kautz, Vazquez, Heidrich & Seidel, "A unified approach to prefiltered environment maps", Eurographics Workshop on
// Rendering 2000.
#pragma once

#include "known_light/irradiance_map.h"
#include "known_light/sun.h"

#include <optional>

namespace bmc {
// Light as a table of directions, linear RGB: texel i of TexelGrid(columns, rows) is at rgb[3 i], and after the last
// one stands the padding of an EnvironmentMap.
struct LightTable {
    double solid_angle;  // of the caps that it averages over
    int columns, rows;
    const float* rgb;
};

// The table that each direction of a rule sees, an array for each member.
struct Caps {
    std::vector<int> columns, rows;
    std::vector<const float*> rgb;

    void add(const LightTable& table);
    Color radiance(std::size_t i, Direction direction) const;
};

class PrefilteredEnvironment {
public:
    // The map must outlive it. Made by so many threads.
    explicit PrefilteredEnvironment(const EnvironmentMap& map, unsigned threads = 1);
    PrefilteredEnvironment(const PrefilteredEnvironment&) = delete;
    PrefilteredEnvironment& operator=(const PrefilteredEnvironment&) = delete;

    // The sun has no part in the caps' means.
    const Sun& sun() const { return sun_; }

    // Caps of the solid angle pi, pi / 4, ..., down to ten texels across; the last table is the map itself. A millionth
    // of the mean over all directions is added to each mean, so that no cap is black where there is light.
    const std::vector<LightTable>& tables() const { return tables_; }

    // The table whose caps are nearest to a solid angle > 0, by the ratio.
    const LightTable& table(double solid_angle) const;

    // E(n) of a unit normal, by the sky, by the sun, and by both.
    Color sky_irradiance(Vec3 normal) const { return irradiance_(normal); }
    Color sun_irradiance(Vec3 normal) const { return sun_irradiance_ ? (*sun_irradiance_)(normal) : Color{}; }
    Color irradiance(Vec3 normal) const { return sky_irradiance(normal) + sun_irradiance(normal); }

private:
    LightTable average(const LightTable& finer, double solid_angle, unsigned threads);

    const Sun sun_;
    const std::optional<EnvironmentMap> without_sun_;  // where there is one
    const EnvironmentMap& sky_;
    IrradianceMap irradiance_;
    std::optional<IrradianceMap> sun_irradiance_;
    std::vector<std::vector<float>> averages_;
    std::vector<LightTable> tables_;
};
}  // namespace bmc
