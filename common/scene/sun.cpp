#include "scene/sun.h"

#include <algorithm>
#include <cstdint>

#include "scene/solid_texels.h"

namespace {

constexpr double bright = 100;  // times the mean

double brightness(Color c) { return c.x + c.y + c.z; }

double all_light(const SolidTexels& texels) {
    double sum = 0;
    for (int row = 0; row < texels.rows(); ++row) {
        Color of_row;
        for (int column = 0; column < texels.columns(); ++column) of_row += texels(row, column);
        sum += texels.solid_angle(row) * brightness(of_row);
    }
    return sum;
}

// The bits of row and column in turns (Morton, "A computer oriented geodetic data base", IBM 1966): texels in this
// order make a compact piece of the map out of any stretch of them, so that few of the rays' strata have an edge
// across.
std::uint64_t z_order(std::uint64_t row, std::uint64_t column) {
    std::uint64_t order = 0;
    for (int bit = 0; bit < 27; ++bit) order |= (row >> bit & 1) << (2 * bit + 1) | (column >> bit & 1) << 2 * bit;
    return order;
}

struct Texel {
    std::uint64_t order;
    int row, column;
};

}  // namespace

Sun::Sun(const EnvironmentMap& map) : map_(map), all_(all_light(SolidTexels(map, 1, 1))) {
    const SolidTexels texels(map, 1, 1);
    const double least = bright * all_ / (4 * portable::pi);
    std::vector<Texel> bright_texels;
    for (int row = 0; row < texels.rows(); ++row)
        for (int column = 0; column < texels.columns(); ++column)
            if (brightness(texels(row, column)) > least)
                bright_texels.push_back(
                    {z_order(static_cast<std::uint64_t>(row), static_cast<std::uint64_t>(column)), row, column});
    std::sort(bright_texels.begin(), bright_texels.end(),
              [](const Texel& a, const Texel& b) { return a.order < b.order; });
    double sum = 0;
    for (const auto& [order, row, column] : bright_texels) {
        const Color light = texels(row, column);
        sum += texels.solid_angle(row) * brightness(light);
        light_.push_back(sum);
        rays_.push_back({direction_of(texels.polar(row + 0.5), texels.azimuth(column)), 1 / brightness(light) * light});
        texels_.push_back(static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width()) +
                          static_cast<std::size_t>(column));
    }
}

const Sun::Ray& Sun::ray(double u) const {
    const auto after = std::upper_bound(light_.begin(), light_.end(), u * light_.back());
    return rays_[std::min(static_cast<std::size_t>(after - light_.begin()), rays_.size() - 1)];
}

EnvironmentMap Sun::without(bool sun) const {
    const float* texels = map_.texels();
    const std::size_t count = 3 * static_cast<std::size_t>(map_.width()) * static_cast<std::size_t>(map_.height());
    std::vector<float> rgb(count);
    if (sun) std::copy(texels, texels + count, rgb.begin());
    for (const std::size_t texel : texels_)
        for (std::size_t i = 3 * texel; i < 3 * texel + 3; ++i) rgb[i] = sun ? 0 : texels[i];
    return EnvironmentMap(map_.width(), map_.height(), std::move(rgb));
}
