// The light as the known part of the integrand. The environment is given, so before it traces a ray, a renderer lacks
// only the visibility v, 0 or 1. For a Lambertian surface with the normal n
//     L_o = (albedo / pi) integral over H of v L cos(theta) d omega
//         ~ (albedo / pi) E(n) sum of w_j L_j v_j / sum of w_j L_j,
// where w_j are the weights of a rule for the known part cos(theta), and L_j is the mean of L over a cap of the solid
// angle 2 pi / N around sample j (Krivanek & Colbert, "Real-time shading with filtered importance sampling", Computer
// Graphics Forum 27(4), 2008). This is a ratio estimator: the quotient estimates the fraction of the light that
// arrives, and E(n), the light without shadows, is known. For a constant v it is exact.
//
// The sun (sun.h) is a second light, with the same quotient. If it sends the share s of the light, it gets s / 2 of
// a pixel's samples, since the edge of its shadow needs few. The rule for the sky gets the others.
#pragma once

#include "beyond/known_light/prefiltered_environment.h"
#include "scene/render.h"

namespace bmc::beyond {
// The number of a pixel's samples that go to the sun: at least one, or none where there is no sun.
std::size_t sun_samples(const PrefilteredEnvironment& light, std::size_t samples);

// The settings of the rules for the sky: without the sun's samples, but at least one.
RenderSettings sky_settings(RenderSettings settings, const PrefilteredEnvironment& light);

// The fraction of each colour of the sky's light that passes the other object.
Color visible_sky(const Scene& scene, const EnvironmentMap& means, const Hit& hit, const QuadratureRule& rule,
                  const Frame& frame);

// L_o, linear RGB, by these rules for the sky and by `sun_rays` rays to the sun. Scene and light must outlive it.
Shader known_light_shader(const Scene& scene, const PrefilteredEnvironment& light, const PixelRules& rules,
                          std::size_t sun_rays);
}  // namespace bmc::beyond
