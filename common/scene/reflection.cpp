#include "scene/reflection.h"

// BEGIN SOLUTION shade
// The cosine belongs to the weights unless it is the rule's known part, which its weights have in them.
CosineRule cosine_rule(const QuadratureRule& rule) {
    CosineRule cosine_rule;
    for (std::size_t i = 0; i < rule.weights.size(); ++i) {
        const Vec3 direction = rule.directions[i];
        const double cosine = knows_cosine(rule.known) ? 1 : direction.y;
        cosine_rule.push_back({Direction(direction), rule.weights[i] * cosine});
    }
    return cosine_rule;
}
// END SOLUTION

// BEGIN SOLUTION shade
// The sum of weights times the environment's radiance in the directions that pass the other object, times albedo / pi.
Color reflected_light(const Scene& scene, const EnvironmentMap& environment, const Hit& hit, const CosineRule& rule,
                      const Frame& frame) {
    Color irradiance;
    for (const auto& [local, weight] : rule) {
        const Direction direction = frame.to_world(local);
        if (!is_shadowed(scene, hit, direction)) irradiance += weight * environment.radiance(direction);
    }
    return 1 / portable::pi * (hit.albedo * irradiance);
}
// END SOLUTION
