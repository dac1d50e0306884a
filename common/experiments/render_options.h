// The options that say how a picture is rendered: for the program that renders one and the command that judges one.
#pragma once

#include "numerics/portable_math.h"

#include <vector>

#include "command_line.h"
#include "scene/render.h"

struct RenderOptions {
    RenderSettings settings;
    ModelOptions model;
    bool light_known = false;  // who renders sets RenderSettings::light, which needs the environment

    // Method, samples, pool.
    std::vector<Option> method_options();

    // Those of the model, which gain the light as a known part. Monte Carlo takes from them where directions are, the
    // seed, and that the light is known; it makes no Gaussian process.
    std::vector<Option> model_options();

    // The settings with what the model's options say. Throws UsageError if the samples are too many for the method.
    RenderSettings chosen() const;

private:
    void add_known_light(Option& known);
};
