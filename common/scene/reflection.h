// What a pixel does with a quadrature rule: the light that a point reflects, if nothing emits but the environment,
//     L_o = integral over H of (albedo / pi) V L cos(theta) dw ~ (albedo / pi) sum of weight_i V_i L_i.
// The visibility V is 0 for a direction that the other object shadows, and 1 for all others.
#pragma once

#include "light/environment.h"
#include "quadrature/quadrature.h"
#include "scene/scene.h"

namespace bmc {
// A rule for the integral of f cos(theta) dw over H, where f is sampled: cos(theta) is in its weights. Each component
// has an array of its own, so that a loop can take eight directions at a time; after the last one stand eight zeros.
struct CosineRule {
    static constexpr std::size_t padding = 8;
    std::vector<float> x = std::vector<float>(padding), y = x, z = x;
    std::vector<double> weights;

    std::size_t size() const { return weights.size(); }
    Direction direction(std::size_t i) const { return {x[i], y[i], z[i]}; }

    void add(Vec3 direction, double weight) {
        x[size()] = static_cast<float>(direction.x);
        y[size()] = static_cast<float>(direction.y);
        z[size()] = static_cast<float>(direction.z);
        for (std::vector<float>* component : {&x, &y, &z}) component->push_back(0);
        weights.push_back(weight);
    }
};

CosineRule cosine_rule(const QuadratureRule& rule);

// L_o, linear RGB, by a rule that the frame carries to the surface.
Color reflected_light(const Scene& scene, const EnvironmentMap& environment, const Hit& hit, const CosineRule& rule,
                      const Frame& frame);
}  // namespace bmc
