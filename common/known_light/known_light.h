// The light as the known part of the integrand. The environment is given, so before it traces a ray, a renderer lacks
// only the visibility v, 0 or 1. For a Lambertian surface with the normal n
//     L_o = (albedo / pi) integral over H of v L cos(theta) d omega
//         ~ (albedo / pi) E(n) sum of w_j L_j v_j / sum of w_j L_j,
// where w_j are the weights of a rule for the known part cos(theta), and L_j is the light in a cone around sample j
// (Krivanek & Colbert, "Real-time shading with filtered importance sampling", Computer Graphics Forum 27(4), 2008).
// This is a ratio estimator: the quotient estimates the fraction of the light that arrives, and E(n), the light
// without shadows, is known. For a constant v it is exact.
//
// The sun, or lamps and windows, which are the texels of more than ten times the mean, is a second light. Few of a
// rule's directions meet it, so it has rays, an E(n), and a quotient of its own.
#pragma once

#include "scene/render.h"

namespace bmc {
// A piece of an environment: the integral of its light, and the mean direction of that, at most 1 long.
struct Lamp {
    Vec3 direction;
    Colour light;
};

// The texels whose R + G + B is at most `most`, as those of 2 rows x rows cells of the map that have light.
std::vector<Lamp> cells_of_light(const EnvironmentMap& map, double most, int rows);

// The texels whose R + G + B exceeds `least`, if there are any, as `count` points of equal light. They are in Morton's
// order: neighbours in the list are mostly neighbours in the map, so the edge of a shadow crosses few parts of it.
std::vector<Lamp> points_of_light(const EnvironmentMap& map, double least, std::size_t count);

// The sum over the lamps of light * max(direction.d - cosine, 0), as a table of 2 rows x rows directions d: for the
// cosine 0 the irradiance E(d), otherwise the light in a cone around d, weighted by a tent. The directions are the
// corners of the table's cells for place = 0, and the middles for 0.5.
EnvironmentMap light_around(const std::vector<Lamp>& lamps, double cosine, int rows, double place, std::size_t threads);

// visible / all for each colour, in [0, 1]; 1 for a colour that no ray carries.
Colour fraction(Colour visible, Colour all);

// Sums of light * max(normal.direction, 0) over lamps: of those that the other object leaves visible, and of all.
struct Arriving {
    Colour visible = {}, all = {};
    void add(const Hit& hit, const Lamp& lamp);
};

// What is known of a light before a ray is traced.
struct KnownLight {
    std::vector<Lamp> sun;                          // points of equal light; none where no texel is so bright
    EnvironmentMap sky_irradiance, sun_irradiance;  // tables of E(n)
    EnvironmentMap sky_cones;                       // the sky in a cone around each direction
    double sun_deviation;                           // of v under the sun, if it is 1 under the sky
    // E(n) of sky and sun.
    Colour irradiance(Vec3 n) const { return sky_irradiance.interpolated(n) + sun_irradiance.interpolated(n); }
};

// The tables of this map, for pictures with so many samples. The map may go.
KnownLight known_light(const EnvironmentMap& map, std::size_t samples, std::size_t threads);

// L_o, linear RGB, with the samples of these settings. The light must outlive it. Throws what the Gaussian processes
// throw.
Shader known_light_shader(const KnownLight& light, RenderSettings settings);
}  // namespace bmc
