#include "known_light/known_light.h"

#include "known_light/known_light_fast.h"
#include "numerics/plain_loops.h"

#include <algorithm>

namespace bmc {
std::size_t sun_samples(const PrefilteredEnvironment& light, std::size_t samples) {
    if (light.sun().empty()) return 0;
    const double half = 0.5 * light.sun().share() * static_cast<double>(samples);
    return std::max<std::size_t>(static_cast<std::size_t>(half + 0.5), 1);
}

RenderSettings sky_settings(RenderSettings settings, const PrefilteredEnvironment& light) {
    const std::size_t sun = sun_samples(light, settings.samples);
    settings.samples = settings.samples > sun ? settings.samples - sun : 1;
    settings.known = KnownPart::cosine;
    return settings;
}

KnownLightRule known_light_rule(const QuadratureRule& rule, const PrefilteredEnvironment& light) {
    const double share = 2 * portable::pi / static_cast<double>(rule.weights.size());
    KnownLightRule known{{cosine_rule(rule)}, {}};
    for (std::size_t i = 0; i < rule.weights.size(); ++i) {
        double& weight = known.directions.weights[i];
        known.caps.add(light.table(std::clamp(weight / rule.directions[i].y, share / 4, share * 4)));
        weight = std::max(weight, 0.0);
    }
    return known;
}

void Quotient::add(Color light, double visibility) {
    all += light;
    visible += visibility * light;
}

Color Quotient::fraction() const {
    const auto of = [](double part, double whole) { return whole > 0 ? part / whole : 1; };
    return {of(visible.x, all.x), of(visible.y, all.y), of(visible.z, all.z)};
}

Color visible_sky(const Scene& scene, const Hit& hit, const KnownLightRule& rule, const Frame& frame) {
    if (!plain_loops) return visible_sky_fast(scene, hit, rule, frame);
    Quotient sky;
    for (std::size_t i = 0; i < rule.directions.size(); ++i) {
        const Direction direction = frame.to_world(rule.directions.direction(i));
        sky.add(rule.directions.weights[i] * rule.caps.radiance(i, direction), !is_shadowed(scene, hit, direction));
    }
    return sky.fraction();
}

VisibleSun visible_sun(const Scene& scene, const PrefilteredEnvironment& light, const Hit& hit, std::size_t rays,
                       Random random) {
    Quotient sun;
    std::optional<bool> last;
    double changes = 0;
    for (std::size_t j = 0; j < rays; ++j) {
        const double stratum = static_cast<double>(j) + random.uniform();
        const Sun::Ray& ray = light.sun().ray(stratum / static_cast<double>(rays));
        const double cosine = dot(hit.normal, ray.direction);
        if (cosine <= 0) continue;
        const bool passes = !is_shadowed(scene, hit, ray.direction);
        sun.add(cosine * ray.colour, passes);
        changes += passes != last.value_or(passes);
        last = passes;
    }
    return {sun.fraction(), changes};
}

Shade reflected_known_light(const Scene& scene, const PrefilteredEnvironment& light, const RenderSettings& settings,
                            const Progress& progress) {
    const RenderSettings sky = sky_settings(settings, light);
    const std::shared_ptr<const Covariance> covariance = settings.make_covariance();
    const auto make = [=, &light](DirectionSet set) {
        const QuadratureRule rule = sky.method == Method::mc
                                        ? monte_carlo_rule(std::move(set))
                                        : bayesian_rule(*covariance, sky.noise, std::move(set.directions), sky.known);
        return std::make_shared<const KnownLightRule>(known_light_rule(rule, light));
    };
    const auto rules = std::make_shared<const PixelRules>(sky, make, progress);
    return [=, &scene, &light, rays = sun_samples(light, settings.samples)](const Hit& hit, Random& random) {
        const auto [rule, frame] = rules->rule_for(hit.normal, random);
        const auto& known = static_cast<const KnownLightRule&>(*rule);
        const Color irradiance =
            light.sky_irradiance(hit.normal) * visible_sky(scene, hit, known, frame) +
            light.sun_irradiance(hit.normal) * visible_sun(scene, light, hit, rays, random).fraction;
        return 1 / portable::pi * (hit.albedo * irradiance);
    };
}
}  // namespace bmc
