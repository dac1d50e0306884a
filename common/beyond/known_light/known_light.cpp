#include "beyond/known_light/known_light.h"

namespace bmc::beyond {
SampleCounts share_out(const EnvironmentLight& light, std::size_t samples) {
    if (!light.averages || light.averages->sun.empty()) return {samples, 0};
    const double rays = 0.5 * light.averages->sun.share() * static_cast<double>(samples);
    const std::size_t sun = std::max<std::size_t>(static_cast<std::size_t>(rays + 0.5), 1);
    return {samples > sun ? samples - sun : 1, sun};
}

// The fraction of each colour of the sky's light that passes the other object.
static Colour visible_sky(const EnvironmentMap& means, const Hit& hit, const QuadratureRule& rule, const Frame& frame) {
    std::vector<int> all(rule.size()), visible(rule.size());  // texels; the black one in the shadow
    for (std::size_t i = 0; i < rule.size(); ++i) {
        const Vec3 direction = frame.to_world(rule.directions[i]);
        all[i] = means.index(direction);
        visible[i] = !is_shadowed(sphere_scene, hit, direction) * all[i];
    }
    if (all == visible) return {1, 1, 1};
    RatioEstimator sky;
    for (std::size_t i = 0; i < rule.size(); ++i) {
        sky.all += rule.weights[i] * means.colour(all[i]);
        sky.visible += rule.weights[i] * means.colour(visible[i]);
    }
    return sky.fraction();
}

Shader shader_of(const EnvironmentLight& any_light, RenderSettings settings) {
    const SampleCounts samples = share_out(any_light, settings.samples);
    settings.samples = samples.sky;
    const PixelRules rules(settings);
    if (!any_light.averages) return environment_shader(any_light.environment, rules);
    const PrefilteredEnvironment& light = *any_light.averages;
    const EnvironmentMap& means = light.means(2 * portable::pi / static_cast<double>(samples.sky));
    return [=, &light, &means](const Hit& hit, int x, int y) {
        Random random = pixel_stream(rules.settings, x, y);
        const OrientedRule oriented = rules.rule_for(hit.normal, random);
        const Colour sky = visible_sky(means, hit, *oriented.rule, oriented.frame);
        const Colour sun = sample_sun(sphere_scene, light.sun, hit, samples.sun, random).fraction();
        return 1 / portable::pi *
               (hit.albedo * (light.sky_irradiance(hit.normal) * sky + light.sun.irradiance(hit.normal) * sun));
    };
}
}  // namespace bmc::beyond
