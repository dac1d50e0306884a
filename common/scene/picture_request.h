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
    std::string report() const override;  // the file; throws what the Gaussian processes throw

    // max_process_samples, or for mc on a lattice, which makes no process, most_lattice_samples.
    std::size_t most_samples() const;
    static constexpr std::size_t most_lattice_samples = 1000000;

    // Throws std::invalid_argument for more samples.
    void require_possible() const;

    // The image as a file; a PPM or BMP has 2^exposure times the radiance.
    std::string file(Image image) const;
};
}  // namespace bmc
