// An environment as a file that other programs read.
#pragma once

#include "command_line/command_line.h"
#include "light/load_environment.h"
#include "scene/image.h"

namespace bmc {
// What `workbench light` prints: the map as PFM.
struct LightFile : Experiment {
    std::string environment = built_in_lights[0];

    void add_options(Options& options) override { options.add("environment", "FILE", environment_help(), environment); }

    std::string report() const override {
        const EnvironmentMap map = load_environment(environment);
        Image image(map.width, map.height);
        for (int y = 0; y < map.height; ++y)
            for (int x = 0; x < map.width; ++x) image(x, y) = map.colour(map.index(x, y));
        return encode(image, Format::pfm);
    }
};
}  // namespace bmc
