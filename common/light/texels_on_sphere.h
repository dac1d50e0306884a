// The texels of an environment map as pieces of the sphere, and means of the map over all directions.
#pragma once

#include "light/environment.h"

#include <algorithm>

namespace bmc {
// The texels that have a solid angle. Only u = 1 or v = 1 meets the last column or row (environment.h), so these have
// no area and are left out; a map of one row or column keeps it. If there are too few texels, each is cut into equal
// pieces.
struct TexelsOnSphere {
    const EnvironmentMap& map;
    const int across, down;  // pieces of a texel
    const int columns, rows;

    explicit TexelsOnSphere(const EnvironmentMap& texels, int min_columns = 1, int min_rows = 1)
        : map(texels),
          across(1 + (min_columns - 1) / std::max(1, map.width - 1)),
          down(1 + (min_rows - 1) / std::max(1, map.height - 1)),
          columns(across * std::max(1, map.width - 1)),
          rows(down * std::max(1, map.height - 1)) {}

    Colour operator()(int row, int column) const { return map.colour(map.index(column / across, row / down)); }

    // The solid angle of one texel of the row.
    double solid_angle(int row) const {
        return 2 * portable::pi / columns * (polar(row).cosine - polar(row + 1).cosine);
    }

    // Sine and cosine of the polar angle at this height, counted in rows: row + 0.5 is the middle of a row.
    portable::SineCosine polar(double height) const { return portable::sincos_turns(0.5 * height / rows); }

    // Sine and cosine of the azimuth at this place, counted in columns from +z over -x.
    portable::SineCosine azimuth(double place) const { return portable::sincos_turns(place / columns - 0.5); }
};

// The direction (sin(polar) sin(azimuth), cos(polar), -sin(polar) cos(azimuth)).
inline Vec3 direction_of(portable::SineCosine polar, portable::SineCosine azimuth) {
    return {polar.sine * azimuth.sine, polar.cosine, -polar.sine * azimuth.cosine};
}

// R + G + B, where one number stands for a radiance.
inline double brightness(Colour c) { return c.x + c.y + c.z; }

// The mean over all directions of f(L).
template <class Function>
double mean_over_directions(const EnvironmentMap& map, Function f) {
    const TexelsOnSphere texels(map);
    double sum = 0;
    for (int row = 0; row < texels.rows; ++row) {
        double row_sum = 0;
        for (int column = 0; column < texels.columns; ++column) row_sum += f(texels(row, column));
        sum += texels.solid_angle(row) * row_sum;
    }
    return sum / (4 * portable::pi);
}
}  // namespace bmc
