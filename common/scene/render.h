// The renderer: what a pixel does with a quadrature rule. The light that a point reflects, if nothing emits but the
// environment (Kajiya, "The rendering equation", SIGGRAPH 1986, without interreflection), is
//     L_o = integral over H of (albedo / pi) v L cos(theta) d omega ~ (albedo / pi) sum of w_i v_i L_i,
// where L is the environment's radiance. The visibility v is 0 in a direction that the other object shadows, and 1 in
// all others.
#pragma once

#include "scene/image.h"
#include "scene/pixel_rules.h"

#include <functional>

namespace bmc {
// L_o, linear RGB, by a rule with the known part cos(theta), which the frame carries to the surface.
Color reflected_radiance(const Scene& scene, const EnvironmentMap& environment, const Hit& hit,
                         const QuadratureRule& rule, const Frame& frame);

// The colour of a point that the camera sees in column x of row y. Several threads call it at once.
using Shader = std::function<Color(const Hit&, int x, int y)>;

// L_o, linear RGB, by these rules. The environment must outlive it.
Shader environment_shader(const EnvironmentMap& environment, const PixelRules& rules);

// The sphere scene in these colours, with the size and the threads of the settings. A pixel that shows no object shows
// the background.
Image render(const EnvironmentMap& background, const RenderSettings& settings, const Shader& shade);

// The same in this light. Throws what the Gaussian processes throw.
Image picture(const EnvironmentMap& light, const RenderSettings& settings);
}  // namespace bmc
