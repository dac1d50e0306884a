#include "light/environment.h"

#include "base/input.h"

#include <algorithm>

namespace bmc {
Colour EnvironmentMap::interpolated(double u, double v) const {
    const int columns = std::max(width - 1, 1), left = static_cast<int>(std::floor(u)) + columns;
    const int above = static_cast<int>(std::floor(v));
    const double s = u - std::floor(u), t = v - std::floor(v);
    const auto in_row = [&](int y) {
        const int clamped = std::clamp(y, 0, height - 1);
        return (1 - s) * colour(index(left % columns, clamped)) + s * colour(index((left + 1) % columns, clamped));
    };
    return (1 - t) * in_row(above) + t * in_row(above + 1);
}

// The last column and the last row have no width. They count only in a map that has no other.
Colour EnvironmentMap::bilinear_radiance(Vec3 direction) const {
    const double v = std::min(row(direction.y) - 0.5, std::max(height - 2.0, 0.0));
    return interpolated(column(direction.x, direction.z) - 0.5, v);
}

EnvironmentMap load_environment(const std::string& name, std::size_t threads) {
    for (std::size_t i = 0; i < std::size(built_in_lights); ++i)
        if (name == built_in_lights[i]) return built_in_light(static_cast<BuiltInLight>(i), threads);
    return read_file(name, read_radiance_hdr, "; lights with a name are " + listed(light_names()));
}
}  // namespace bmc
