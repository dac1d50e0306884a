// The light as the known part of the integrand. The environment is given; what a renderer does not know before it
// traces a ray is the visibility V, 0 or 1. For a Lambertian surface with the normal n
//     L_o = (albedo / pi) integral over H of V L cos(theta) dw
//         ~ (albedo / pi) E(n) sum of w_j L_j V_j / sum of w_j L_j,
// where w_j are the weights of a rule for the known part cos(theta), and L_j the mean of L over the cap around sample j
// whose solid angle is the sample's own, w_j / cos(theta_j). The quotient makes a constant V exact. Means over the
// solid angles of samples come from Krivanek & Colbert, "Real-time shading with filtered importance sampling", Computer
// Graphics Forum 27(4), 2008; tables of them from Kautz, Vazquez, Heidrich & Seidel, "A unified approach to prefiltered
// environment maps", Eurographics Workshop on Rendering 2000.
#pragma once

#include "scene/environment.h"
#include "scene/irradiance_map.h"

#include <optional>
#include <vector>

// Light as a table of directions, linear RGB: texel i of TexelGrid(columns, rows) is at rgb[3 i].
struct LightTable {
    double solid_angle;  // of the caps that it averages over
    int columns, rows;
    const float* rgb;
};

class PrefilteredEnvironment {
public:
    // The map must outlive it.
    explicit PrefilteredEnvironment(const EnvironmentMap& map);
    PrefilteredEnvironment(const PrefilteredEnvironment&) = delete;
    PrefilteredEnvironment& operator=(const PrefilteredEnvironment&) = delete;

    // Caps of solid angle pi, by quarters down to ten texels across, and last the map itself. A texel of a table holds
    // the mean over all the caps whose centres lie in it, so that the table holds as much light as the map, however
    // small the source; and a millionth of the mean over all directions, so that where there is light no cap is black.
    const std::vector<LightTable>& tables() const { return tables_; }

    // The table whose caps come nearest to a solid angle > 0 by their ratio.
    const LightTable& table(double solid_angle) const;

    // E(n) of a unit normal.
    Color irradiance(Vec3 normal) const { return irradiance_(normal); }

private:
    IrradianceMap irradiance_;
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
