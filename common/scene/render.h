// The renderer: the light that is reflected by each point that the camera sees, if nothing but the environment emits
// (Kajiya, "The rendering equation", SIGGRAPH 1986, without interreflection),
//     L_o = integral over H of (albedo / pi) v L cos(theta) d omega ~ (albedo / pi) sum of w_i v_i L_i,
// where L is the environment's radiance. The visibility v is 0 in a direction that the other object shadows, and 1 in
// all others.
#pragma once

#include "light/environment.h"
#include "scene/image.h"
#include "scene/pixel_rules.h"
#include "scene/scene.h"

#include <functional>

namespace bmc {
// L_o, linear RGB, by a cosine rule, which the frame carries to the surface.
Colour reflected_radiance(const Scene& scene, const EnvironmentMap& environment, const Hit& hit,
                          const QuadratureRule& rule, const Frame& frame);

// The colour of a point that the camera sees in column x of row y. Several threads call it at once.
using Shader = std::function<Colour(const Hit&, int x, int y)>;

// L_o, linear RGB, by these rules. The environment must outlive it.
Shader environment_shader(const EnvironmentMap& environment, const PixelRules& rules);

// The sphere scene in these colours, with the size and the threads of the settings. A pixel that shows no object shows
// the background.
Image render(const EnvironmentMap& background, const RenderSettings& settings, const Shader& shade);
}  // namespace bmc
