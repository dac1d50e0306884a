#include "known_light/known_light.h"

#include "known_light/known_light_fast.h"
#include "numerics/plain_loops.h"

#include <algorithm>

namespace bmc {
std::size_t sun_samples(const PrefilteredEnvironment& light, std::size_t samples, double part) {
    if (light.sun().empty()) return 0;
    const double rays = part * light.sun().share() * static_cast<double>(samples);
    return std::max<std::size_t>(static_cast<std::size_t>(rays + 0.5), 1);
}

RenderSettings sky_settings(RenderSettings settings, const PrefilteredEnvironment& light, double part) {
    const std::size_t sun = sun_samples(light, settings.samples, part);
    settings.samples = settings.samples > sun ? settings.samples - sun : 1;
    return settings;
}

Color visible_sky(const Scene& scene, const EnvironmentMap& means, const Hit& hit, const CosineRule& rule,
                  const Frame& frame) {
    if (!plain_loops) return visible_sky_fast(scene, means, hit, rule, frame);
    Quotient sky;
    for (std::size_t i = 0; i < rule.size(); ++i) {
        const Direction direction = frame.to_world(rule.direction(i));
        sky.add(rule.weights[i] * means.radiance(direction), !is_shadowed(scene, hit, direction));
    }
    return sky.fraction();
}

Shade reflected_known_light(const Scene& scene, const PrefilteredEnvironment& light, const RenderSettings& settings) {
    const RenderSettings sky = sky_settings(settings, light);
    const auto rules = std::make_shared<const PixelRules>(sky);
    const EnvironmentMap& means = light.means(2 * portable::pi / static_cast<double>(sky.samples));
    const std::size_t rays = sun_samples(light, settings.samples);
    return [=, &scene, &light, &means](const Hit& hit, int x, int y) {
        Random random = pixel_stream(settings, x, y);
        const auto [rule, frame] = rules->rule_for(hit.normal, random);
        const Color irradiance =
            light.sky_irradiance(hit.normal) * visible_sky(scene, means, hit, *rule, frame) +
            light.sun_irradiance(hit.normal) * light_of_sun(scene, light.sun(), hit, rays, random).fraction();
        return 1 / portable::pi * (hit.albedo * irradiance);
    };
}
}  // namespace bmc
