// What the programs are asked for: the options of a Gaussian process and of its samples, which both programs take, and
// a picture of the sphere scene. Options set the members of a struct, which must outlive them and not move.
#pragma once

#include "command_line/command_line.h"
#include "light/desert.h"
#include "scene/render.h"

namespace bmc {
// The largest Gaussian process that a program accepts: Q has 128 MiB and takes seconds to factor.
constexpr std::uint64_t max_process_samples = 4096;

// The help text of an option that takes the name of a light.
constexpr const char* environment_help = "a Radiance .hdr file, bright-desert, black-and-white (default desert)";

// The options of a process (covariance, smoothness, length-scale, noise, known) and of its samples (placement, seed).
Options model_options(ModelSettings& settings);

struct PictureRequest {
    RenderSettings settings;
    std::string environment = built_in_lights[0];
    Format format = Format::ppm;
    double exposure = 0;  // in stops

    PictureRequest();  // on all processors

    Options options();

    // Throws std::invalid_argument for more than 4096 samples, except for mc on a lattice.
    void require_possible() const;

    // The image of linear radiance. Throws what the Gaussian processes throw.
    Image image(const EnvironmentMap& light) const;

    // The image as a file; a PPM has 2^exposure times the radiance.
    std::string file(Image image) const;
};

// Prints a warning on stderr if the weights of these rules cannot make a good picture: S > 2 (stability_constant), or a
// sum below half of the integral of the known part.
void warn_of_weights(const PixelRules& rules);
}  // namespace bmc
