// What the renderer is asked for: a picture of the sphere scene.
#pragma once

#include "command_line/model_options.h"
#include "light/load_environment.h"
#include "scene/render.h"

namespace bmc {
struct PictureRequest : Experiment {
    RenderSettings settings;
    std::string environment = built_in_lights[0];
    Format format = Format::ppm;
    double exposure = 0;  // in stops

    PictureRequest();  // on all processors

    void add_options(Options& options) override;
    std::string report() const override;  // the file

    // Throws std::invalid_argument for more than 4096 samples, except for mc on a lattice.
    void require_possible() const;

    // The image of linear radiance. Throws what the Gaussian processes throw.
    virtual Image image(const EnvironmentMap& light) const;

    // The image as a file; a PPM has 2^exposure times the radiance.
    std::string file(Image image) const;
};

// The image of linear radiance, after warnings on stderr. Throws what the Gaussian processes throw.
Image warned_picture(const EnvironmentMap& light, const RenderSettings& settings);

// Prints a warning on stderr if the error of these rules is more than twice that of Monte Carlo with as many samples in
// one of two worlds, a white one or one of noise (white_brightness, noise_gain): in the mean over the shared rules, or
// over twenty fresh ones where pixels share none.
void warn_of_weights(const PixelRules& rules);
}  // namespace bmc
