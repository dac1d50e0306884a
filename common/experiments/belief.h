// What a Gaussian process believes of the light that arrives at a point of the rectangle, as a picture.
#pragma once

#include "command_line/model_options.h"
#include "light/load_environment.h"

namespace bmc {
// What `workbench belief` prints: four discs side by side, as PPM. They show the light and the samples, the posterior
// mean, the posterior standard deviation, and the error of the mean. stderr has the estimate of the integral.
struct Belief : Experiment {
    std::size_t samples = 40;
    std::string environment = built_in_lights[0];
    ModelSettings settings;

    void add_options(Options& options) override;
    std::string report() const override;
};
}  // namespace bmc
