#include "scene/reflection.h"

#include "numerics/plain_loops.h"
#include "scene/reflection_fast.h"

namespace bmc {
// BEGIN SOLUTION shade
// Weights get the factor cos(theta), unless it is the rule's known part: then they have it already.
CosineRule cosine_rule(const QuadratureRule& rule) {
    CosineRule folded;
    for (std::size_t i = 0; i < rule.weights.size(); ++i) {
        const Vec3 direction = rule.directions[i];
        const double factor = rule.known == Known::nothing ? direction.y : 1;
        folded.add(direction, rule.weights[i] * factor);
    }
    return folded;
}
// END SOLUTION

// BEGIN SOLUTION shade
// The sum of weights times the environment's radiance in the directions that pass the other object, times albedo / pi.
Color reflected_light(const Scene& scene, const EnvironmentMap& environment, const Hit& hit, const CosineRule& rule,
                      const Frame& frame) {
    if (!plain_loops) return reflected_light_fast(scene, environment, hit, rule, frame);
    Color irradiance;
    for (std::size_t i = 0; i < rule.size(); ++i) {
        const Direction direction = frame.to_world(rule.direction(i));
        if (!is_shadowed(scene, hit, direction)) irradiance += rule.weights[i] * environment.radiance(direction);
    }
    return 1 / portable::pi * (hit.albedo * irradiance);
}
// END SOLUTION
}  // namespace bmc
