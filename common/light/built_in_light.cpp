#include "base/progress.h"
#include "light/environment.h"

#include <stdexcept>

namespace bmc {
constexpr Vec3 sun{0.8, 0.48, 0.36};  // a Pythagorean unit vector
constexpr Colour zenith{0.03, 0.17, 0.56}, horizon{0.72, 0.70, 0.66}, sand{0.58, 0.31, 0.14}, rock{0.62, 0.23, 0.10};

static double clamp01(double t) { return t > 0 ? (t < 1 ? t : 1) : 0; }

static Colour mix(Colour a, Colour b, double t) { return (1 - t) * a + t * b; }

// 0 below -width / 2, 1 above width / 2. The default is one and a half texels, so that silhouettes do not alias.
static double edge(double distance, double width = 0.009) {
    const double t = clamp01(distance / width + 0.5);
    return t * t * (3 - 2 * t);
}

// Uniform in [0, 1) at every lattice point: a mixed product of large odd numbers.
static double lattice(int i, int j) {
    std::uint32_t h = static_cast<std::uint32_t>(i) * 0x9e3779b1u ^ static_cast<std::uint32_t>(j) * 0x85ebca77u;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12)) * 0x297a2d39u;
    return (h ^ (h >> 15)) * 0x1p-32;
}

// Smooth noise in [0, 1) with features of size 1.
static inline double noise(double x, double y) {
    const double floor_x = std::floor(x), floor_y = std::floor(y);
    const int i = static_cast<int>(floor_x), j = static_cast<int>(floor_y);
    const double s = edge(x - floor_x - 0.5, 1), t = edge(y - floor_y - 0.5, 1);
    return (1 - t) * ((1 - s) * lattice(i, j) + s * lattice(i + 1, j)) +
           t * ((1 - s) * lattice(i, j + 1) + s * lattice(i + 1, j + 1));
}

// 1 in a disc of radius 5 degrees around the sun, 0 outside.
static inline double sun_disc(double to_sun) { return edge(to_sun - 0.9981, 0.001); }

static inline Colour sky(Vec3 d) {
    const double to_sun = clamp01(0.5 + 0.5 * dot(d, sun)), glow = to_sun * to_sun * to_sun * to_sun;
    const double halo = 0.004 / (0.004 + (1 - to_sun));
    const Colour air = (0.8 + 0.2 * to_sun) * mix(horizon, zenith, std::sqrt(clamp01(1.1 * d.y)));
    const Colour haze = mix(air, {1.0, 0.94, 0.84}, 0.8 * glow * std::sqrt(glow) + 0.2 * halo);
    return mix(haze, {1.0, 0.98, 0.92}, sun_disc(to_sun));
}

// Dunes on a plane one unit below the eye; haze swallows them with distance.
static inline Colour ground(Vec3 d) {
    const double distance = 1 / (0.01 - d.y);
    const double x = 0.6 * distance * d.x, z = 0.6 * distance * d.z;
    const double slope = noise(x + 0.2, 1.6 * z + 0.2) - noise(x - 0.2, 1.6 * z - 0.2);
    const Colour lit = (0.80 - 0.45 * slope) * sand;
    return mix(lit, horizon, 0.7 * clamp01(distance / (distance + 15)));
}

// A skyline around the horizon: flat tops where the noise is high, gentle hills elsewhere.
static double skyline(Vec3 d, double scale, double height) {
    const double to_circle = scale / std::sqrt(d.x * d.x + d.z * d.z + 1e-9);
    const double n = noise(to_circle * d.x + 40 * scale, to_circle * d.z);
    return height * (0.15 + 0.25 * n + 0.6 * edge(n - 0.62, 0.12)) - d.y;
}

static inline Colour strata(double height) { return (0.85 + 0.3 * noise(45 * height, 0.5)) * rock; }

// A fin of sandstone in the plane z = -1 around the hole |x / 0.48|^3 + |(y + 0.12) / 0.585|^3 < 1. Its surface bends
// towards the nearer border.
static inline Colour arch(Colour behind, Vec3 d) {
    const double u = d.x / -d.z, v = d.y / -d.z;
    if (!(d.z < 0 && std::fabs(u) < 1 && v < 0.7 && v > -0.1)) return behind;
    const double x = u + 0.06 * (noise(7 * u, 7 * v) - 0.5), y = v + 0.06 * (noise(7 * u, 7 * v + 50) - 0.5);
    const double a = x / 0.48, b = (y + 0.12) / 0.585;
    const Vec3 outward{a * std::fabs(a) / 0.48, b * std::fabs(b) / 0.585, 0};
    const double hole = (a * a * std::fabs(a) + b * b * std::fabs(b) - 1) / (3 * length(outward) + 1e-9);
    const Vec3 upward = normalize({1.7 * x, 1, 0});
    const double roof = (0.555 - 0.85 * x * x - y) * upward.y;
    const double worn_hole = 1 - edge(hole - 0.04, 0.08), worn_roof = 1 - edge(roof - 0.05, 0.1);
    const Vec3 into_hole = (-worn_hole / (length(outward) + 1e-9)) * outward;
    const Vec3 normal = normalize(Vec3{0, 0, 0.6} + worn_roof * upward + into_hole);
    const Colour lit = (0.35 + 0.95 * clamp01(dot(normal, sun))) * strata(v + 0.1 * noise(3 * u, 3 * v));
    return mix(behind, lit, edge(hole) * edge(roof) * edge(v + 0.07));
}

// Mountains up to a skyline, of rock that haze pales.
static inline Colour mountains(Colour behind, Vec3 d, double scale, double height, double foot, double strata_scale,
                               double haze) {
    const Colour paled = mix(strata(strata_scale * d.y), horizon, haze);
    return mix(behind, paled, edge(skyline(d, scale, height)) * edge(d.y + foot));
}

// What stands before ground and sky, the far things first, except what cannot be seen at this height.
static inline Colour desert_colour(Colour colour, Vec3 d) {
    if (d.y > 0.5 || d.y < -0.1) return colour;
    if (d.y < 0.14) colour = mountains(colour, d, 3, 0.13, 0, 3, 0.62);
    if (d.y < 0.09) colour = mountains(colour, d, 5, 0.08, 0.01, 2, 0.35);
    colour = arch(colour, d);
    return {clamp01(colour.x), clamp01(colour.y), clamp01(colour.z)};
}

// The light from a direction whose ground and sky have this colour.
static inline Colour light_colour(BuiltInLight light, Colour colour, Vec3 d) {
    switch (light) {
        case BuiltInLight::desert: return desert_colour(colour, d);
        case BuiltInLight::bright_desert:
            return (1 + 999 * sun_disc(0.5 + 0.5 * dot(d, sun))) * desert_colour(colour, d);
        case BuiltInLight::black_and_white: return d.x > 0 ? Colour{1, 1, 1} : Colour{};
    }
    throw std::logic_error("light_colour has no case for this light");
}

// The map of a light at the centres of texels.
EnvironmentMap built_in_light(BuiltInLight light, std::size_t threads) {
    constexpr int width = 1024, height = 512;
    EnvironmentMap map(width, height);
    const TexelsOnSphere texels(map);
    std::vector<portable::SineCosine> azimuths;
    for (int i = 0; i < width; ++i) azimuths.push_back(texels.azimuth(i + 0.5));
    for_each_row(height, threads, [&](int j) {
        const portable::SineCosine polar = texels.polar(j + 0.5);
        const double above = edge(polar.cosine);
        std::vector<Vec3> directions(width);
        for (std::size_t i = 0; i < width; ++i) directions[i] = direction_of(polar, azimuths[i]);
        std::vector<Colour> colours(width);
        for (std::size_t i = 0; i < width && above < 1; ++i) colours[i] = ground(directions[i]);
        for (std::size_t i = 0; i < width && above > 0; ++i) colours[i] = mix(colours[i], sky(directions[i]), above);
        for (std::size_t i = 0; i < width; ++i)
            map.set(static_cast<int>(i), j, light_colour(light, colours[i], directions[i]));
    });
    return map;
}
}  // namespace bmc
