#include "scene/environment.h"

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

EnvironmentMap::EnvironmentMap(int width, int height, std::vector<float> rgb)
    : grid_(width, height), height_(height), rgb_(std::move(rgb)) {
    const std::string size = std::to_string(width) + " x " + std::to_string(height) + " texels";
    if (width < 1 || height < 1 || std::int64_t{width} * height > max_texels)
        throw std::invalid_argument("environment map of " + size + ": it takes 1 to " + std::to_string(max_texels));
    if (rgb_.size() != 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        throw std::invalid_argument("environment map of " + size + " with " + std::to_string(rgb_.size()) + " values");
    rgb_.resize(rgb_.size() + beyond);
    for (std::size_t i = 0; i < rgb_.size(); ++i) {
        if (rgb_[i] >= 0 && rgb_[i] <= FLT_MAX) continue;
        const std::size_t columns = static_cast<std::size_t>(width);
        throw std::invalid_argument("environment map, row " + std::to_string(i / 3 / columns) + ", column " +
                                    std::to_string(i / 3 % columns) + ": " + std::to_string(rgb_[i]) +
                                    " is not a finite radiance >= 0");
    }
}

// The last column and the last row count only in a map that has no other: they have no width.
Color EnvironmentMap::interpolated_radiance(Vec3 direction) const {
    const int columns = std::max(width() - 1, 1), last_row = std::max(height() - 2, 0);
    const double u = grid_.column(direction.x, direction.z) - 0.5, v = grid_.row(direction.y) - 0.5;
    const double s = u - std::floor(u), t = v - std::floor(v);
    const int left = static_cast<int>(std::floor(u)) + columns, above = static_cast<int>(std::floor(v));
    const auto row = [&](int y) {
        const int begin = std::clamp(y, 0, last_row) * width();
        return (1 - s) * texel(begin + left % columns) + s * texel(begin + (left + 1) % columns);
    };
    return (1 - t) * row(above) + t * row(above + 1);
}
