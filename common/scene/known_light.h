// The light as the known part of the integrand. The environment is given; what a renderer does not know before it
// traces a ray is the visibility V, 0 or 1. For a Lambertian surface with the normal n
//     L_o = (albedo / pi) integral over H of V L cos(theta) dw
//         ~ (albedo / pi) E(n) sum of w_j L_j V_j / sum of w_j L_j,
// where w_j are the weights of a rule for the known part cos(theta), and L_j the mean of L over the cap around sample j
// whose solid angle is the sample's own, w_j / cos(theta_j). The quotient makes a constant V exact. Means over the
// solid angles of samples come from Krivanek & Colbert, "Real-time shading with filtered importance sampling", Computer
// Graphics Forum 27(4), 2008.
#pragma once

#include "scene/prefiltered_environment.h"
#include "scene/reflection.h"

#include <vector>

// For each direction of the rule the averages of the light over caps of about the sample's solid angle: between a
// quarter of an even share of the hemisphere and four times as much, also where a weight is negative.
std::vector<const LightTable*> caps_of(const QuadratureRule& rule, const PrefilteredEnvironment& light);

// L_o, linear RGB, by a rule that the frame carries to the surface, and caps[i] of its directions.
Color reflected_known_light(const Scene& scene, const PrefilteredEnvironment& light, const Hit& hit,
                            const CosineRule& rule, const std::vector<const LightTable*>& caps, const Frame& frame);
