// The texels of an environment map as pieces of the sphere, for averages over directions.
#pragma once

#include "light/environment.h"

#include <algorithm>

namespace bmc {
// The texels that have a solid angle: all but the last row and the last column, unless there is one only. If there are
// too few of them, each is cut into equal pieces.
class TexelsOnSphere {
public:
    TexelsOnSphere(const EnvironmentMap& map, int min_columns, int min_rows)
        : map_(map),
          across_(1 + (min_columns - 1) / std::max(1, map.width() - 1)),
          down_(1 + (min_rows - 1) / std::max(1, map.height() - 1)),
          columns_(across_ * std::max(1, map.width() - 1)),
          rows_(down_ * std::max(1, map.height() - 1)) {}

    int columns() const { return columns_; }
    int rows() const { return rows_; }

    Color operator()(int row, int column) const { return map_.texel(row / down_ * map_.width() + column / across_); }

    // Of one texel of the row.
    double solid_angle(int row) const {
        return 2 * portable::pi / columns_ * (polar(row).cosine - polar(row + 1).cosine);
    }

    // Of the angle between +y and a height in rows, from 0 to rows(): row + 0.5 is the middle of a row.
    portable::SineCosine polar(double height) const { return portable::sincos_turns(0.5 * height / rows_); }

    // Of the azimuth, from +z over -x, in columns, likewise.
    portable::SineCosine azimuth(double place) const { return portable::sincos_turns(place / columns_ - 0.5); }

private:
    const EnvironmentMap& map_;
    int across_, down_, columns_, rows_;
};

// The direction (sin(polar) sin(azimuth), cos(polar), -sin(polar) cos(azimuth)).
inline Vec3 direction_of(portable::SineCosine polar, portable::SineCosine azimuth) {
    return {polar.sine * azimuth.sine, polar.cosine, -polar.sine * azimuth.cosine};
}
}  // namespace bmc
