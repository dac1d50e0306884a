// What the renderer says of a picture on stderr: what to expect of it, and what cures it.
#pragma once

#include "scene/render.h"

namespace bmc {
// If this many samples in random directions miss this light, prints a note on what to expect; returns whether they do:
// whether 1.4 c / sqrt(samples), the error relative to the brightness, is above a half. c is the contrast of the light,
// and 1.4 the median over 21 lights, from 0.9 to 2.6; for one small lamp 2 / sqrt(3) = 1.155 can be derived.
bool note_missed_light(const EnvironmentMap& light, std::size_t samples);

// environment_shader by the rules of these settings. First prints a warning, if in one of two worlds, a white one or
// one of noise (white_brightness, noise_gain), their error is more than twice that of Monte Carlo with as many samples.
// Throws what the Gaussian processes throw.
Shader warned_shader(const EnvironmentMap& light, const RenderSettings& settings);

// Prints a warning if more than a tenth of the objects' pixels is brighter than white, at this exposure.
void warn_of_exposure(const Image& image, double exposure);
}  // namespace bmc
