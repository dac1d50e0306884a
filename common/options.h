// The options of a Gaussian process and its samples, which both programs take, and of how a picture is rendered. They
// set the members of a settings struct, which must outlive them and not move.
#pragma once

#include "command_line.h"
#include "scene/render.h"

#include <vector>

namespace bmc {
// The largest Gaussian process that a program accepts: Q has 128 MiB and takes seconds to factor.
constexpr long max_process_samples = 4096;

// For the help text of an option that takes the name.
constexpr const char* environment_help =
    "light from a Radiance .hdr file, bright-desert (its sun a thousand times brighter) or black-and-white (half of "
    "the directions bring light)";

struct ModelOptions {
    std::vector<Option> process;  // covariance, smoothness, length-scale, noise
    Option known, placement, seed;

    explicit ModelOptions(ModelSettings& settings);
};

// Throws UsageError for a known part with which the covariance has no closed form.
void require_closed_form(const ModelSettings& settings);

// Monte Carlo takes no option of a process.
struct RenderOptions : ModelOptions {
    Option method, samples, pool;

    explicit RenderOptions(RenderSettings& settings);
};

// Throws UsageError for settings that no picture can be rendered by.
void require_possible(const RenderSettings& settings);
}  // namespace bmc
