#include "beyond/sun.h"

namespace bmc::beyond {
// The bits of row and column in turns (Morton, "A computer oriented geodetic data base", IBM 1966). Neighbours in this
// order are a compact piece of the map, so the edge of a shadow crosses few of the rays' strata.
static std::uint64_t z_order(int row, int column) {
    std::uint64_t order = 0;
    for (int bit = 0; bit < 27; ++bit)
        order |= std::uint64_t(row >> bit & 1) << (2 * bit + 1) | std::uint64_t(column >> bit & 1) << 2 * bit;
    return order;
}

Sun::Sun(const EnvironmentMap& map, double threshold)
    : all_(4 * portable::pi * mean_over_directions(map, brightness)), least_(threshold * all_ / (4 * portable::pi)) {
    const TexelsOnSphere whole(map);
    columns_ = whole.columns;
    for (int row = 0; row < whole.rows; ++row) {
        const double top = whole.polar(row).cosine, bottom = whole.polar(row + 1).cosine;
        for (int column = 0; column < whole.columns; ++column) {
            const Colour light = whole(row, column);
            if (!(brightness(light) > least_)) continue;
            texels_.push_back({z_order(row, column), row, column, light, top, bottom});
        }
    }
    std::sort(texels_.begin(), texels_.end(), [](const Texel& a, const Texel& b) { return a.order < b.order; });
    for (Texel& texel : texels_) {
        light_.push_back(light_.back() + whole.solid_angle(texel.row) * brightness(texel.colour));
        texel.colour = 1 / brightness(texel.colour) * texel.colour;
    }
    if (empty()) return;
    for (int step = 0; step <= steps; ++step) {
        const auto end = std::upper_bound(light_.begin() + 1, light_.end() - 1, light() * step / steps);
        first_.push_back(static_cast<std::size_t>(end - light_.begin() - 1));
    }
    Vec3 mean;
    for (int step = 0; step < steps; ++step) mean += 1.0 / steps * ray((step + 0.5) / steps, 0.5).direction;
    spread_ = std::sqrt(std::max(1 - dot(mean, mean), 1e-12));
}

Sun::Ray Sun::ray(double across, double down) const {
    const double before = across * light();
    const std::size_t* first = &first_[static_cast<std::size_t>(std::min(across * steps, steps - 1.0))];
    const double* end = std::upper_bound(&light_[first[0] + 1], &light_[first[1] + 1], before);  // of the texel's light
    const Texel& texel = texels_[static_cast<std::size_t>(end - &light_[1])];
    const double cosine = texel.top + down * (texel.bottom - texel.top), right = (before - end[-1]) / (*end - end[-1]);
    const portable::SineCosine azimuth = portable::sincos_turns((texel.column + right) / columns_ - 0.5);
    return {direction_of({std::sqrt((1 - cosine) * (1 + cosine)), cosine}, azimuth), texel.colour};
}

std::shared_ptr<const EnvironmentMap> Sun::sky(const EnvironmentMap& map) const {
    if (empty()) return {std::shared_ptr<void>(), &map};  // owns nothing
    const auto sky = std::make_shared<EnvironmentMap>(map);
    for (const Texel& texel : texels_) sky->set(texel.column, texel.row, {});
    return sky;
}

Colour RatioEstimator::fraction() const {
    const auto of = [](double part, double whole) { return whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 1; };
    return {of(visible.x, all.x), of(visible.y, all.y), of(visible.z, all.z)};
}

RatioEstimator sample_sun(const Scene& scene, const Sun& sun, const Hit& hit, std::size_t m, Random& random) {
    RatioEstimator light;
    for (std::size_t j = 0; j < m; ++j) {
        const double u = (static_cast<double>(j) + random.uniform()) / static_cast<double>(m);
        const double down = random.uniform();
        const Sun::Ray ray = sun.ray(u, down);
        const double cosine = dot(hit.normal, ray.direction);
        if (cosine <= 0) continue;
        light.all += cosine * ray.colour;
        if (!is_shadowed(scene, hit, ray.direction)) light.visible += cosine * ray.colour;
    }
    return light;
}
}  // namespace bmc::beyond
