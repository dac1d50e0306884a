// What the renderer is asked for, a picture of the sphere scene, and what it says of the picture on stderr: what to
// expect of it, and what cures it.
#pragma once

#include "command_line/command_line.h"
#include "light/environment.h"
#include "scene/render.h"

namespace bmc {
struct PictureRequest {
    RenderSettings settings;
    bool light_known = false;  // of the integrand L(omega) v(omega) cos(theta), beside the cosine
    std::string environment = built_in_lights[0];
    Format format = Format::ppm;
    double exposure = 0;  // in stops

    void add_options(Arguments& arguments);  // they set members, and must not outlive them

    // The image as a file; a PPM or BMP has 2^exposure times the radiance. Throws what the Gaussian processes throw.
    std::string report(Arguments& arguments);
};

// If this many samples in random directions miss this light, prints a note that says how uneven it is; returns whether
// they do: whether c / sqrt(samples), about the error relative to the brightness, is above a half. c is the standard
// deviation of the light over its mean, of what reaches the objects. A lamp that fills the fraction f of all
// directions, in a world that is black elsewhere, has 1 + c^2 = 1 / f.
bool note_missed_light(const EnvironmentMap& light, std::size_t samples);

// The picture with the rules of these settings. First prints a warning, if in one of two worlds, a white one or one of
// noise (white_brightness, noise_gain), their error is more than twice that of Monte Carlo with as many samples. Throws
// what the Gaussian processes throw.
Image warned_picture(const EnvironmentMap& light, const RenderSettings& settings);

// Prints a warning if more than a tenth of the objects' pixels is brighter than white, at this exposure.
void warn_of_exposure(const Image& image, double exposure);
}  // namespace bmc
