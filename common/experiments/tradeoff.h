// What accuracy costs: the time of each step of a rule, and the errors and the time of a picture by every method.
#pragma once

#include "command_line/model_options.h"
#include "experiments/picture_cost.h"

namespace bmc {
// The seconds, measured here, of each step from drawing n directions to their weights (Sobolev 3/2, noise 0.01): draw,
// Q, factor, z, weights. The last one is z by 50,000 random directions, which a program without a closed form needs.
std::vector<double> rule_seconds(std::size_t n);

// What `workbench tradeoff` prints.
struct TradeoffReport : PictureReport {
    std::vector<std::size_t> samples{10, 40};

    void add_options(Options& options) override;
    std::string report() const override;
    std::string table(const std::string& name, const EnvironmentMap& light) const override;
};
}  // namespace bmc
