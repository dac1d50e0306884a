// The renderer: at every point that the camera sees, the direct light
//     L_o = integral over H of (albedo / pi) L_i(w) cos(theta) dw
// that the environment sends past the other object, by one quadrature rule (Kajiya, "The rendering equation", SIGGRAPH
// 1986, for surfaces that do not emit and without interreflection).
#pragma once

#include "scene/environment.h"
#include "scene/image.h"
#include "scene/pixel_rules.h"
#include "scene/scene.h"

#include <functional>

// Called with the fraction of the steps that are done, rules and rows, from one thread.
using Progress = std::function<void(double)>;

// The image of linear radiance, or of its predicted standard errors, 0 where no object is. Every pixel draws from a
// random stream of its own. Throws what the Gaussian processes throw.
Image render(const Scene& scene, const Light& light, const RenderSettings& settings,
             const Progress& progress = nullptr);
