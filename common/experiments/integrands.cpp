#include "experiments/integrands.h"

#include <numeric>
#include <stdexcept>

namespace bmc {
Integrand integrand_named(std::string_view name) {
    if (name == "cosine") return {"cos(theta)", [](Vec3 w) { return w.y; }, portable::pi};
    if (name == "cosine-cubed") return {"cos(theta)^3", [](Vec3 w) { return w.y * w.y * w.y; }, portable::pi / 2};
    if (name == "environment") return environment_integrand(std::make_shared<const EnvironmentMap>(load_environment()));
    if (name == "constant") return {"1", [](Vec3) { return 1.0; }, 2 * portable::pi};
    throw std::logic_error("there is no integrand " + std::string(name));
}

Integrand environment_integrand(const std::shared_ptr<const EnvironmentMap>& light) {
    const Frame frame(normalize({0.3, 0.6, -0.7}));
    const auto value = [=](Vec3 omega) { return luminance(light->radiance(frame.to_world(omega))) * omega.y; };
    return {"L(omega) cos(theta), the built-in environment above a tilted surface", value, reference_integral(value)};
}

double reference_integral(const std::function<double(Vec3)>& f) {
    return estimate(monte_carlo_rule(fibonacci_directions(1 << 18)), f);
}

std::vector<double> unknown_part(const std::function<double(Vec3)>& f, const std::vector<Vec3>& directions,
                                 Known known) {
    std::vector<double> values;
    values.reserve(directions.size());
    for (const Vec3& omega : directions) values.push_back(f(omega) / known_part(known, omega));
    return values;
}

double estimate(const QuadratureRule& rule, const std::function<double(Vec3)>& f) {
    const std::vector<double> values = unknown_part(f, rule.directions, rule.known);
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
