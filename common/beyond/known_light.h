// The light as the known part of the integrand. The environment is given, so before it traces a ray, a renderer lacks
// only the visibility v, 0 or 1. For a Lambertian surface with the normal n
//     L_o = (albedo / pi) integral over H of v L cos(theta) d omega
//         ~ (albedo / pi) E(n) sum of w_j L_j v_j / sum of w_j L_j,
// where w_j are the weights of a rule for the known part cos(theta), and L_j is the mean of L over a cap of the solid
// angle 2 pi / N around sample j (Krivanek & Colbert, "Real-time shading with filtered importance sampling", Computer
// Graphics Forum 27(4), 2008). This is a ratio estimator: the quotient estimates the fraction of the light that
// arrives, and E(n), the light without shadows, is known. For a constant v it is exact.
//
// The sun (sun.h), or lamps and windows, is a second light with a quotient of its own. The error of each light is in
// proportion to its E(n) times the deviation d of its visibility. If errors fall like n^-a, the best shares of a pixel
// are in proportion to (E d)^(1 / (a + 1/2)): to E d for Monte Carlo (Neyman, "On the two different aspects of
// the representative method", Journal of the Royal Statistical Society 97(4), 1934), and to (E d)^(3/4) for good
// directions, a = 5/6. The smaller the sun, the fewer pixels see an edge of a shadow cross it: d is 1 for the sky, and
// for the sun 0.4 times the fourth root of the spread of its directions. Of thirty such rules this has the smallest
// error, in the geometric mean under 23 lights: suns of 0.3 to 15 degrees and seven photographs are among them.
#pragma once

#include "beyond/sun.h"
#include "scene/render.h"

namespace bmc::beyond {
// Means of an environment over caps of several sizes, as tables: a ray that stands for a cap of directions sees them
// (Kautz, Vazquez, Heidrich & Seidel, "A unified approach to prefiltered environment maps", Eurographics Workshop on
// Rendering 2000).
struct PrefilteredEnvironment {
    Sun sun;  // has no part in the means over caps

    // The map must outlive it. threads: how many to use.
    explicit PrefilteredEnvironment(const EnvironmentMap& map, std::size_t threads = 1);

    // The table whose caps are nearest in size, by ratio, to this solid angle > 0. There are tables for pi, pi / 4,
    // ..., until a cap is ten texels wide, and below that the map itself. A millionth of the mean over all directions
    // is added to each mean, so that no cap is black where there is light.
    const EnvironmentMap& means(double solid_angle) const;

    // The irradiance by the sky, and by the sun, of a surface that nothing shadows, with the unit normal n:
    //     E(n) = integral of L cos(theta) d omega over the hemisphere around n.
    // They are from tables; their errors are below 2e-3 of the largest E, and below 9e-3 of it where a small sun is on
    // the horizon. (Nine harmonics would err by a few per cent: Ramamoorthi & Hanrahan, "An efficient representation
    // for irradiance environment maps", SIGGRAPH 2001.)
    Colour sky_irradiance(Vec3 normal) const { return in_table(sky_irradiance_, normal); }
    Colour sun_irradiance(Vec3 normal) const { return in_table(sun_irradiance_, normal); }
    Colour irradiance(Vec3 normal) const { return sky_irradiance(normal) + sun_irradiance(normal); }

private:
    struct Table {
        double solid_angle;  // of the caps that it averages over
        std::shared_ptr<const EnvironmentMap> means;
    };

    std::vector<Table> tables_;  // the smallest caps first, which are the texels of the sky
    EnvironmentMap sky_irradiance_, sun_irradiance_;

    static Colour in_table(const EnvironmentMap& table, Vec3 normal) {
        return table.interpolated(table.column(normal.x, normal.z), table.row(normal.y));
    }
};

// An environment, and its averages if it is known; the settings below then know the cosine.
struct EnvironmentLight {
    const EnvironmentMap& environment;
    std::shared_ptr<const PrefilteredEnvironment> averages;

    EnvironmentLight(const EnvironmentMap& map, bool known, std::size_t threads)
        : environment(map), averages(known ? std::make_shared<const PrefilteredEnvironment>(map, threads) : nullptr) {}
};

// How a pixel's samples are shared out, from its irradiances: at least one to each light, but none to a sun that does
// not reach it.
struct SampleCounts {
    std::size_t sky, sun;
};
SampleCounts share_out(const Sun& sun, Colour by_sky, Colour by_sun, std::size_t samples);

// The colour of each point of a picture. The environment must outlive it. The sky does not have a rule of every size: a
// pixel takes the next smaller one, and gives the rest to the sun, if it sees that. Throws what the Gaussian processes
// throw.
Shader light_shader(const EnvironmentLight& light, RenderSettings settings);
}  // namespace bmc::beyond
