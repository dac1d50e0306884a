#include "known_light/sun.h"

#include <algorithm>

#include "light/texels_on_sphere.h"

namespace bmc {
namespace {

constexpr double sun_threshold = 100;  // times the mean

double brightness(Color c) { return c.x + c.y + c.z; }

double all_light(const TexelsOnSphere& texels) {
    double sum = 0;
    for (int row = 0; row < texels.rows(); ++row) {
        Color of_row;
        for (int column = 0; column < texels.columns(); ++column) of_row += texels(row, column);
        sum += texels.solid_angle(row) * brightness(of_row);
    }
    return sum;
}

// The bits of row and column in turns (Morton, "A computer oriented geodetic data base", IBM 1966). Neighbours in this
// order are a compact piece of the map, so the edge of a shadow crosses few of the rays' strata.
std::uint64_t z_order(std::uint64_t row, std::uint64_t column) {
    std::uint64_t order = 0;
    for (int bit = 0; bit < 27; ++bit) order |= (row >> bit & 1) << (2 * bit + 1) | (column >> bit & 1) << 2 * bit;
    return order;
}

}  // namespace

Sun::Sun(const EnvironmentMap& map) : map_(map), all_(all_light(TexelsOnSphere(map, 1, 1))) {
    const TexelsOnSphere texels(map, 1, 1);
    const double least = sun_threshold * all_ / (4 * portable::pi);
    for (int row = 0; row < texels.rows(); ++row)
        for (int column = 0; column < texels.columns(); ++column) {
            const Color light = texels(row, column);
            if (!(brightness(light) > least)) continue;
            const auto i = static_cast<std::uint64_t>(row), j = static_cast<std::uint64_t>(column);
            const Ray ray{direction_of(texels.polar(row + 0.5), texels.azimuth(column)), 1 / brightness(light) * light};
            texels_.push_back({z_order(i, j), static_cast<std::size_t>(row * map.width() + column), ray,
                               texels.solid_angle(row) * brightness(light)});
        }
    std::sort(texels_.begin(), texels_.end(), [](const Texel& a, const Texel& b) { return a.order < b.order; });
    for (std::size_t i = 1; i < texels_.size(); ++i) texels_[i].light += texels_[i - 1].light;
}

const Sun::Ray& Sun::ray(double u) const {
    const auto after = std::upper_bound(texels_.begin(), texels_.end() - 1, u * texels_.back().light,
                                        [](double light, const Texel& texel) { return light < texel.light; });
    return after->ray;
}

EnvironmentMap Sun::keep(Part part) const {
    const float* texels = map_.texels();
    std::vector<float> sky(texels, texels + 3 * static_cast<std::ptrdiff_t>(map_.width()) * map_.height());
    std::vector<float> sun(sky.size());
    for (const Texel& texel : texels_)
        for (std::size_t i = 3 * texel.index; i < 3 * texel.index + 3; ++i) std::swap(sun[i], sky[i]);
    return EnvironmentMap(map_.width(), map_.height(), std::move(part == Part::sun ? sun : sky));
}
}  // namespace bmc
