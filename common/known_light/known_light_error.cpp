#include "known_light/known_light_error.h"

namespace bmc {
namespace {

MakeRule modelled_rules(const RenderSettings& sky, const PrefilteredEnvironment& light) {
    const std::shared_ptr<const Covariance> covariance = sky.make_covariance();
    return [=, &light](DirectionSet set) {
        if (sky.method == Method::mc)
            return std::make_shared<const ModelledLightRule>(
                ModelledLightRule{known_light_rule(monte_carlo_rule(std::move(set)), light), {}});
        GaussianProcess process(*covariance, sky.noise, std::move(set.directions), sky.known);
        const QuadratureRule rule{process.directions(), process.weights(), sky.known};
        return std::make_shared<const ModelledLightRule>(
            ModelledLightRule{known_light_rule(rule, light), std::move(process)});
    };
}

}  // namespace

PixelError error_of_visible_sky(const Scene& scene, const PrefilteredEnvironment& light, const Hit& hit,
                                const ModelledLightRule& rule, const Frame& frame) {
    std::vector<double> visible;
    double weights = 0, squared_weights = 0;
    Color parts, squared_parts;
    for (std::size_t j = 0; j < rule.directions.size(); ++j) {
        const Direction direction = frame.to_world(rule.directions.direction(j));
        const double weight = rule.directions.weights[j];
        const Color part = weight * rule.caps.radiance(j, direction);
        visible.push_back(!is_shadowed(scene, hit, direction));
        weights += weight;
        squared_weights += weight * weight;
        parts += part;
        squared_parts += part * part;
    }
    std::vector<double> values = deviations(visible);
    double even = 1;  // U of an even light, over the sum of e_j^2
    if (rule.process) {
        values = rule.process->cholesky().solve_lower(values);
        even = rule.process->variance() / (portable::pi * portable::pi) * (weights * weights) / squared_weights;
    }
    PixelError error{{}, {}, values.size()};
    const Color irradiance = light.sky_irradiance(hit.normal), brdf = 1 / portable::pi * hit.albedo;
    error.squared_amplitude =
        brdf * brdf * (sum_of_squares(values) / static_cast<double>(values.size() - 1) * (irradiance * irradiance));
    for (const auto channel : channels)
        if (parts.*channel > 0)
            error.unit_variance.*channel = even * squared_parts.*channel / (parts.*channel * parts.*channel);
    return error;
}

Color variance_of_visible_sun(const Scene& scene, const PrefilteredEnvironment& light, const Hit& hit, std::size_t rays,
                              const Random& random) {
    if (rays < 2) return {};
    const Color sun = 1 / portable::pi * hit.albedo * light.sun_irradiance(hit.normal);
    const double m = static_cast<double>(rays);
    return visible_sun(scene, light, hit, rays, random).changes / (2 * m * (m - 1)) * (sun * sun);
}

ErrorOf error_of_known_light(const Scene& scene, const PrefilteredEnvironment& light, const RenderSettings& settings,
                             const Progress& progress) {
    const RenderSettings sky = sky_settings(settings, light);
    const auto rules = std::make_shared<const PixelRules>(sky, modelled_rules(sky, light), progress);
    return [=, &scene, &light, rays = sun_samples(light, settings.samples)](const Hit& hit, Random& random) {
        const auto [rule, frame] = rules->rule_for(hit.normal, random);
        PixelError error = error_of_visible_sky(scene, light, hit, static_cast<const ModelledLightRule&>(*rule), frame);
        error.other_variance = variance_of_visible_sun(scene, light, hit, rays, random);
        return error;
    };
}
}  // namespace bmc
