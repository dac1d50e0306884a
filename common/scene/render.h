// The renderer: at every point that the camera sees, the direct light
//     L_o = integral over H of (albedo / pi) L_i(w) cos(theta) dw
// that the environment sends past the other object, by one quadrature rule (Kajiya, "The rendering equation", SIGGRAPH
// 1986, for surfaces that do not emit and without interreflection).
#pragma once

#include "scene/image.h"
#include "scene/pixel_rules.h"

#include <functional>

namespace bmc {
// The colour of a point that the camera sees in column x of row y. Many threads call it.
using Shade = std::function<Color(const Hit&, int x, int y)>;

// L_o, linear RGB, by these rules. Scene and environment must outlive it.
Shade reflected_environment(const Scene& scene, const EnvironmentMap& environment, const PixelRules& rules);

// The image of these colours, with the size and the threads of the settings. A pixel that shows no object shows the
// background.
Image render(const Scene& scene, const EnvironmentMap& background, const RenderSettings& settings, const Shade& shade);
}  // namespace bmc
