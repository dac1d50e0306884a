// The light as the known part of the integrand. The environment is given. Before it traces a ray, a renderer does not
// know the visibility V, 0 or 1. For a Lambertian surface with the normal n
//     L_o = (albedo / pi) integral over H of V L cos(theta) dw
//         ~ (albedo / pi) E(n) sum of w_j L_j V_j / sum of w_j L_j,
// where w_j are the weights of a rule for the known part cos(theta). L_j is the mean of L over a cap around sample j,
// whose solid angle is 2 pi / N. For a constant V the quotient is exact.
// Means over the solid angles of samples come from Krivanek & Colbert, "Real-time shading with filtered importance
// sampling", Computer Graphics Forum 27(4), 2008.
//
// The sun (sun.h) is a light of its own, with the same quotient. If it sends the share s of the light, it gets s / 2 of
// a pixel's samples: the edge of its shadow needs few. The rule for the sky gets the others. Each gets at least one.
#pragma once

#include "known_light/prefiltered_environment.h"
#include "scene/render.h"

namespace bmc {
// How many of a pixel's samples go to the sun: a part of s of them, but at least one; none where there is no sun.
std::size_t sun_samples(const PrefilteredEnvironment& light, std::size_t samples, double part = 0.5);

// The settings of the rule for the sky: without the sun's samples.
RenderSettings sky_settings(RenderSettings settings, const PrefilteredEnvironment& light, double part = 0.5);

// The fraction of each colour of the sky's light that passes the other object.
Color visible_sky(const Scene& scene, const EnvironmentMap& means, const Hit& hit, const CosineRule& rule,
                  const Frame& frame);

// The L_o, linear RGB, of a picture's points. Scene and light must outlive it. Throws what Gaussian processes throw.
Shade reflected_known_light(const Scene& scene, const PrefilteredEnvironment& light, const RenderSettings& settings);
}  // namespace bmc
