// What the renderer is asked for: a picture of the sphere scene.
#pragma once

#include "command_line/model_options.h"
#include "light/environment.h"
#include "scene/render.h"

namespace bmc {
struct PictureRequest : Experiment {
    RenderSettings settings;
    std::string environment = built_in_lights[0];
    Format format = Format::ppm;
    double exposure = 0;  // in stops

    void add_options(Options& options) override;

    // The image as a file; a PPM or BMP has 2^exposure times the radiance. Throws what the Gaussian processes throw.
    std::string report() const final;

    // The image of linear radiance in this light. Prints what to expect of it.
    virtual Image image(const EnvironmentMap& light) const;
};
}  // namespace bmc
