#include "experiments/integrands.h"

#include "light/environment.h"

#include <numeric>

namespace bmc {
// In the order of their names. The environment's takes time, so it is left out where it is not wanted.
std::vector<Integrand> practice_integrands(std::size_t chosen) {
    const bool lit = chosen == 0 || practice_integrand_names[chosen] == std::string("environment");
    const std::vector<Integrand> all{
        {"cos(theta)", [](Vec3 omega) { return omega.y; }, portable::pi},
        {"cos(theta)^3", [](Vec3 omega) { return omega.y * omega.y * omega.y; }, portable::pi / 2},
        lit ? environment_integrand(std::make_shared<const EnvironmentMap>(load_environment())) : Integrand{},
        {"1", [](Vec3) { return 1.0; }, 2 * portable::pi}};
    if (chosen == 0) return all;
    return {all.at(chosen - 1)};
}

Integrand environment_integrand(const std::shared_ptr<const EnvironmentMap>& light) {
    const Frame frame(normalize({0.3, 0.6, -0.7}));
    const auto value = [=](Vec3 omega) { return luminance(light->radiance(frame.to_world(omega))) * omega.y; };
    return {"L(omega) cos(theta), the built-in environment above a tilted surface", value, reference_integral(value)};
}

double reference_integral(const std::function<double(Vec3)>& f) {
    return estimate(monte_carlo_rule(fibonacci_directions(1 << 18)), f);
}

std::vector<double> evaluate(const std::function<double(Vec3)>& f, const std::vector<Vec3>& directions, KnownPart p) {
    std::vector<double> values;
    for (const Vec3& omega : directions) values.push_back(f(omega) / known_value(p, omega));
    return values;
}

double estimate(const QuadratureRule& rule, const std::function<double(Vec3)>& f) {
    const std::vector<double> values = evaluate(f, rule.directions, rule.known_part);
    return std::inner_product(values.begin(), values.end(), rule.weights.begin(), 0.0);
}

// n and e select the random stream.
std::function<std::vector<Vec3>(std::size_t)> directions_of_estimates(const ModelSettings& settings, std::size_t n) {
    return [=, seed = settings.seed, sampler = sampler_of(settings.placement, n)](std::size_t e) {
        Random random(seed, (std::uint64_t{n} << 32) + e);
        return sampler(random);
    };
}
}  // namespace bmc
