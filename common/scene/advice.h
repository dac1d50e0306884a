// What the renderer says of a picture on stderr: what to expect of it, and what cures it.
#pragma once

#include "light/environment.h"
#include "scene/image.h"
#include "scene/pixel_rules.h"

namespace bmc {
// If this many samples in random directions miss this light, prints how uneven it is, and what cures that: if
// c / sqrt(samples), about the error relative to the brightness, is above a half. c is the standard deviation of the
// light over its mean, of what reaches the objects. A lamp that fills the fraction f of all directions, in a world that
// is black elsewhere, has 1 + c^2 = 1 / f.
void note_uneven_light(const EnvironmentMap& light, std::size_t samples);

// Prints a warning, if in one of two worlds, a white one or one of noise (white_brightness, noise_gain), the error by
// these rules is more than twice that of Monte Carlo with as many samples.
void warn_of_weights(const PixelRules& rules);

// Prints a warning if more than a tenth of the objects' pixels is brighter than white, at this exposure in stops.
void warn_of_exposure(const Image& image, double exposure);
}  // namespace bmc
