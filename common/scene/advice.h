// What the renderer says of a picture on stderr: what to expect of it, and what cures it.
#pragma once

#include "light/environment.h"
#include "scene/image.h"
#include "scene/pixel_rules.h"

namespace bmc {
// Prints how uneven this light is, and what cures that, where so many samples in random directions miss it: where
// c / sqrt(samples), about the relative error of a picture, exceeds a half. c is the standard deviation of the light
// that reaches the objects, over its mean. A lamp that fills the fraction f of all directions, in a world that is black
// elsewhere, has 1 + c^2 = 1 / f.
void note_uneven_light(const EnvironmentMap& light, std::size_t samples);

// Prints a warning, if in one of two worlds, a white one or one of noise (white_brightness, noise_gain), the error by
// these rules is more than twice that of Monte Carlo with as many samples.
void warn_of_weights(const PixelRules& rules);

// Prints a warning if more than a tenth of the objects' pixels is brighter than white, at this exposure in stops.
void warn_of_exposure(const Image& image, double exposure);
}  // namespace bmc
