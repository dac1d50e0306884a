#include "scene/sun.h"

#include <algorithm>

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

}  // namespace

Sun::Sun(const EnvironmentMap& map) : map_(map), all_(all_light(SolidTexels(map, 1, 1))) {
    const SolidTexels texels(map, 1, 1);
    const double least = bright * all_ / (4 * portable::pi);
    double sum = 0;
    for (int row = 0; row < texels.rows(); ++row)
        for (int column = 0; column < texels.columns(); ++column) {
            const Color light = texels(row, column);
            if (brightness(light) <= least) continue;
            sum += texels.solid_angle(row) * brightness(light);
            light_.push_back(sum);
            rays_.push_back(
                {direction_of(texels.polar(row + 0.5), texels.azimuth(column)), 1 / brightness(light) * light});
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
