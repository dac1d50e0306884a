#include "sharing/shared_light.h"

namespace bmc {
namespace {

constexpr double sun_part = 0.8;

// The turn of a pixel's directions, in [0, 1): the fractional part of x / g + y / g^2, where g^3 = g + 1.
double r2_turns(int x, int y) {
    const double t = 0.75487766624669276 * x + 0.56984029099805327 * y;
    return t - std::floor(t);
}

}  // namespace

Views sky_views(const Scene& scene, const PrefilteredEnvironment& light, const RenderSettings& settings) {
    Views views{settings.width, settings.height};
    const PixelRules rules(sky_settings(settings, light, sun_part));
    const CosineRule& rule = rules.shared()[0];
    const int window = (2 * views.reach() + 1) * (2 * views.reach() + 1);
    const EnvironmentMap& means = light.means(2 * portable::pi / (static_cast<double>(rule.size()) * window));
    const bool swapped = settings.seed % 2 == 0;
    const Camera camera{settings.width, settings.height};
    const auto row = [&](int y) {
        for (int x = 0; x < settings.width; ++x)
            if (const std::optional<Hit> hit = intersect(scene, camera.ray(x, y))) {
                const Frame frame = Frame(hit->normal).rotated(swapped ? r2_turns(y, x) : r2_turns(x, y));
                views.at(x, y) = {hit->object, visible_sky(scene, means, *hit, rule, frame)};
            }
    };
    for_each_row(settings.height, settings.threads, row, settings.progress);
    return views;
}

// Sums over the pixels of the object; n times those about their mean are exact. They give the slopes by Cramer's rule.
Color Views::shared_fraction(int x, int y) const {
    const View& own = at(x, y);
    const int r = reach();
    double n = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
    Color f, uf, vf;
    for (int j = std::max(-r, -y); j <= std::min(r, height - 1 - y); ++j)
        for (int i = std::max(-r, -x); i <= std::min(r, width - 1 - x); ++i) {
            const View& neighbour = at(x + i, y + j);
            if (neighbour.object != own.object) continue;
            n += 1, u += i, v += j, uu += i * i, uv += i * j, vv += j * j;
            f += neighbour.fraction;
            uf += double(i) * neighbour.fraction;
            vf += double(j) * neighbour.fraction;
        }
    uu = n * uu - u * u, uv = n * uv - u * v, vv = n * vv - v * v;
    const double determinant = uu * vv - uv * uv;
    if (n < 6 || determinant <= 0) return own.fraction;
    uf = n * uf - u * f, vf = n * vf - v * f;
    const Color a = 1 / determinant * (vv * uf - uv * vf), b = 1 / determinant * (uu * vf - uv * uf);
    const Color middle = 1 / n * (f - u * a - v * b);
    const auto fraction = [](double c) { return std::clamp(c, 0.0, 1.0); };
    return {fraction(middle.x), fraction(middle.y), fraction(middle.z)};
}

Shade reflected_shared_light(const Scene& scene, const PrefilteredEnvironment& light, const RenderSettings& settings) {
    const auto sky = std::make_shared<const Views>(sky_views(scene, light, settings));
    return [=, &scene, &light, rays = sun_samples(light, settings.samples, sun_part)](const Hit& hit, int x, int y) {
        Random random = pixel_stream(settings, x, y);
        const Color irradiance =
            light.sky_irradiance(hit.normal) * sky->shared_fraction(x, y) +
            light.sun_irradiance(hit.normal) * light_of_sun(scene, light.sun(), hit, rays, random).fraction();
        return 1 / portable::pi * (hit.albedo * irradiance);
    };
}
}  // namespace bmc
