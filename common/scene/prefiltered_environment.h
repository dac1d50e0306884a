// Means of an environment over caps of several sizes, as tables: what a ray that stands for a cap of directions sees.
// Kautz, Vazquez, Heidrich & Seidel, "A unified approach to prefiltered environment maps", Eurographics Workshop on
// Rendering 2000.
#pragma once

#include "scene/environment.h"
#include "scene/irradiance_map.h"
#include "scene/sun.h"

#include <optional>
#include <vector>

// Light as a table of directions, linear RGB: texel i of TexelGrid(columns, rows) is at rgb[3 i],
// and after them stands what EnvironmentMap::beyond says.
struct LightTable {
    double solid_angle;  // of the caps that it averages over
    int columns, rows;
    const float* rgb;

    Color radiance(Direction direction) const {
        const float* texel = rgb + 3 * std::ptrdiff_t{grid().texel_index(direction.x, direction.y, direction.z)};
        return {texel[0], texel[1], texel[2]};
    }
    TexelGrid grid() const { return {columns, rows}; }
};

class PrefilteredEnvironment {
public:
    // The map must outlive it.
    explicit PrefilteredEnvironment(const EnvironmentMap& map);
    PrefilteredEnvironment(const PrefilteredEnvironment&) = delete;
    PrefilteredEnvironment& operator=(const PrefilteredEnvironment&) = delete;

    // The sun has no part in the caps' means.
    const Sun& sun() const { return sun_; }

    // Caps of solid angle pi, by quarters down to ten texels across, and last the map itself. A texel of a table holds
    // the mean over all the caps whose centres lie in it, so that the table holds as much light as the map, however
    // small the source; and a millionth of the mean over all directions, so that where there is light no cap is black.
    const std::vector<LightTable>& tables() const { return tables_; }

    // The table whose caps come nearest to a solid angle > 0 by their ratio.
    const LightTable& table(double solid_angle) const;

    // E(n) of a unit normal, by the sky, by the sun, and by both.
    Color sky_irradiance(Vec3 normal) const { return irradiance_(normal); }
    Color sun_irradiance(Vec3 normal) const { return sun_irradiance_ ? (*sun_irradiance_)(normal) : Color{}; }
    Color irradiance(Vec3 normal) const { return sky_irradiance(normal) + sun_irradiance(normal); }

private:
    const Sun sun_;
    const std::optional<EnvironmentMap> without_sun_;  // where there is one
    const EnvironmentMap& sky_;
    IrradianceMap irradiance_;
    std::optional<IrradianceMap> sun_irradiance_;
    std::vector<std::vector<float>> caps_;
    std::vector<LightTable> tables_;
};

// The light of a scene: the environment, which must outlive it, and its averages, made when they are first asked for.
// One thread at a time may ask.
class Light {
public:
    Light(const EnvironmentMap& environment) : environment_(environment) {}

    const EnvironmentMap& environment() const { return environment_; }
    const PrefilteredEnvironment& averages() const { return averages_ ? *averages_ : averages_.emplace(environment_); }

private:
    const EnvironmentMap& environment_;
    mutable std::optional<PrefilteredEnvironment> averages_;
};
