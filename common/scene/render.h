// The renderer: the direct light L_o (reflection.h) of every point that the camera sees.
#pragma once

#include "scene/image.h"
#include "scene/pixel_rules.h"

#include <functional>

namespace bmc {
// The colour of a point that the camera sees in column x of row y. Several threads call it at once.
using Shader = std::function<Colour(const Hit&, int x, int y)>;

// L_o, linear RGB, by these rules. The environment must outlive it.
Shader environment_shader(const EnvironmentMap& environment, const PixelRules& rules);

// The sphere scene in these colours, with the size and the threads of the settings. A pixel that shows no object shows
// the background.
Image render(const EnvironmentMap& background, const RenderSettings& settings, const Shader& shade);
}  // namespace bmc
