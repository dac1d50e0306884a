// What a pixel does with a quadrature rule: the light that a point reflects, if nothing emits but the environment
// (Kajiya, "The rendering equation", SIGGRAPH 1986, without interreflection),
//     L_o = integral over H of (albedo / pi) v L cos(theta) d omega ~ (albedo / pi) sum of w_i v_i L_i,
// where L is the environment's radiance. The visibility v is 0 in a direction that the other object shadows, and 1 in
// all others.
#pragma once

#include "light/environment.h"
#include "quadrature/quadrature.h"
#include "scene/scene.h"

namespace bmc {
// L_o, linear RGB, by a rule with the known part cos(theta), which the frame carries to the surface.
Colour reflected_radiance(const Scene& scene, const EnvironmentMap& environment, const Hit& hit,
                          const QuadratureRule& rule, const Frame& frame);
}  // namespace bmc
