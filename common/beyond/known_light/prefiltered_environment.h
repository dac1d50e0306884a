// Means of an environment over caps of several sizes, as tables: a ray that stands for a cap of directions sees them.
// Kautz, Vazquez, Heidrich & Seidel, "A unified approach to prefiltered environment maps", Eurographics Workshop on
// Rendering 2000.
#pragma once

#include "beyond/known_light/sun.h"

namespace bmc::beyond {
struct PrefilteredEnvironment {
    const Sun sun;  // has no part in the means over caps

    // The map must outlive it. threads: how many to use. Throws std::runtime_error if a radiance exceeds 1e36.
    explicit PrefilteredEnvironment(const EnvironmentMap& map, std::size_t threads = 1);

    // The table whose caps are nearest in size, by ratio, to this solid angle > 0. There are tables for pi, pi / 4,
    // ..., until a cap is ten texels wide, and below that the map itself. A millionth of the mean over all directions
    // is added to each mean, so that no cap is black where there is light.
    const EnvironmentMap& means(double solid_angle) const;

    // The irradiance by the sky of a surface that nothing shadows, with the unit normal n:
    //     E(n) = integral of L cos(theta) d omega over the hemisphere around n.
    // It is from a table; its error is below 2e-3 of the largest E. (Nine harmonics would err by a few per cent:
    // Ramamoorthi & Hanrahan, "An efficient representation for irradiance environment maps", SIGGRAPH 2001.)
    Colour sky_irradiance(Vec3 normal) const {
        return irradiance_.interpolated(irradiance_.column(normal.x, normal.z), irradiance_.row(normal.y));
    }

private:
    struct Table {
        double solid_angle;  // of the caps that it averages over
        std::shared_ptr<const EnvironmentMap> means;
    };

    std::vector<Table> tables_;  // the smallest caps first, which are the texels of the sky
    const EnvironmentMap irradiance_;
};
}  // namespace bmc::beyond
