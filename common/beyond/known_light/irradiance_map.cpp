#include "beyond/known_light/irradiance_map.h"

#include "beyond/known_light/texels_on_sphere.h"
#include "numerics/work.h"

namespace bmc::beyond {
// The cells that light is gathered in, and the cells of the table, which holds E at their corners.
constexpr int light_columns = 96, light_rows = 48, columns = 128, rows = 64;

// The part, of `parts` equal ones, that texel i of n lies in.
static std::size_t part_with(int i, int n, int parts) { return static_cast<std::size_t>(std::int64_t{i} * parts / n); }

// The integral of L omega d omega for each cell and each colour.
static std::vector<Vec3> fluxes(const EnvironmentMap& environment) {
    const TexelsOnSphere texels(environment, light_columns, light_rows);
    std::vector<Vec3> azimuths;
    for (int i = 0; i < texels.columns(); ++i) azimuths.push_back(direction_of({1, 0}, texels.azimuth(i + 0.5)));
    std::vector<Vec3> fluxes(3 * light_columns * light_rows);
    for (int row = 0; row < texels.rows(); ++row) {
        const portable::SineCosine polar = texels.polar(row + 0.5);
        const double solid_angle = texels.solid_angle(row);
        for (int column = 0; column < texels.columns(); ++column) {
            const Color light = solid_angle * texels(row, column);
            const Vec3 azimuth = azimuths[static_cast<std::size_t>(column)];
            const Vec3 direction{polar.sine * azimuth.x, polar.cosine, polar.sine * azimuth.z};
            Vec3* flux = &fluxes[3 * (part_with(row, texels.rows(), light_rows) * light_columns +
                                      part_with(column, texels.columns(), light_columns))];
            for (const double colour : {light.x, light.y, light.z}) *flux++ += colour * direction;
        }
    }
    return fluxes;
}

// E(n) is the sum of max(n . F, 0) over the fluxes F. Only cells cut by n's horizon are underestimated.
IrradianceMap::IrradianceMap(const EnvironmentMap& environment, std::size_t threads) : table_(columns + 1, rows + 1) {
    const std::vector<Vec3> flux = fluxes(environment);
    for_each_row(rows + 1, threads, [&](int row) {
        const portable::SineCosine polar = portable::sincos_turns(0.5 * row / rows);
        double x[columns + 1], z[columns + 1], sums[3][columns + 1] = {};
        for (int i = 0; i <= columns; ++i) {
            const Vec3 normal = direction_of(polar, portable::sincos_turns(static_cast<double>(i) / columns - 0.5));
            x[i] = normal.x;
            z[i] = normal.z;
        }
        for (std::size_t f = 0; f < flux.size(); ++f) {
            const double vertical = polar.cosine * flux[f].y;
            double* sum = sums[f % 3];
            for (int i = 0; i <= columns; ++i) {
                const double e = x[i] * flux[f].x + vertical + z[i] * flux[f].z;
                sum[i] += e > 0 ? e : 0;
            }
        }
        for (int i = 0; i <= columns; ++i) table_.set(i, row, {sums[0][i], sums[1][i], sums[2][i]});
    });
}

Color IrradianceMap::operator()(Vec3 normal) const {
    return table_.interpolated(table_.grid().column(normal.x, normal.z), table_.grid().row(normal.y));
}
}  // namespace bmc::beyond
