// The light as the known part of the integrand. The environment is given; what a renderer does not know before it
// traces a ray is the visibility V, 0 or 1. For a Lambertian surface with the normal n
//     L_o = (albedo / pi) integral over H of V L cos(theta) dw
//         ~ (albedo / pi) E(n) sum of w_j L_j V_j / sum of w_j L_j,
// where w_j are the weights of a rule for the known part cos(theta), none below 0, and L_j the mean of L over the cap
// around sample j whose solid angle is the sample's own, w_j / cos(theta_j). The quotient makes a constant V exact.
// Means over the solid angles of samples come from Krivanek & Colbert, "Real-time shading with filtered importance
// sampling", Computer Graphics Forum 27(4), 2008.
//
// The sun (sun.h) is a light of its own, with the same quotient: its rays j = 0 .. m - 1 go to the texels after the
// fractions (j + u_j) / m of its light, u_j random numbers of the pixel, and w_j is cos(theta_j), 0 below the horizon.
// Of a pixel's samples the sun has half of its share of the light, one at least, and the sky's rule has the others, one
// at least: the edge of what hides the sun needs few.
#pragma once

#include "scene/prefiltered_environment.h"
#include "scene/reflection.h"

#include <vector>

// How many of a pixel's samples go to the sun: none where there is none, otherwise one at least.
std::size_t sun_samples(const PrefilteredEnvironment& light, std::size_t samples);

// The rule with weights for the quotient.
CosineRule quotient_rule(const QuadratureRule& rule);

// For each direction of the rule the averages of the light over caps of about the sample's solid angle: between a
// quarter of an even share of the hemisphere and four times as much, also where a weight is negative.
std::vector<const LightTable*> caps_of(const QuadratureRule& rule, const PrefilteredEnvironment& light);

// A pixel's rays to the sun: their number, and the random numbers that they begin with.
struct SunRays {
    std::size_t count = 0;
    Random random{0, 0};
};

// The fraction of each colour of the sun's light that passes the other object, 1 where no ray has any; and how often a
// ray passes and the next one does not, or the other way round.
struct VisibleSun {
    Color fraction;
    double changes;
};
VisibleSun visible_sun(const Scene& scene, const PrefilteredEnvironment& light, const Hit& hit, const SunRays& rays);

// L_o, linear RGB, by a quotient rule that the frame carries to the surface, caps[i] of its directions, and the sun.
Color reflected_known_light(const Scene& scene, const PrefilteredEnvironment& light, const Hit& hit,
                            const CosineRule& rule, const std::vector<const LightTable*>& caps, const Frame& frame,
                            const SunRays& sun);
