// What it saves to know the light, and how well a better picture predicts the error of one.
#pragma once

#include "beyond/prediction/prediction.h"
#include "experiments/picture_cost.h"

namespace bmc::beyond {
// The fraction of the errors, colour by colour, that are at most twice the standard errors predicted for them.
double coverage(const Image& image, const Image& truth, const Image& predicted);

// What `workbench known-light` prints.
struct KnownLightReport : PictureReport {
    std::string table(const std::string& name, const EnvironmentMap& map) const override;
};

// The commands of the workbench that go beyond the practice.
inline std::vector<Command> commands() {
    static KnownLightReport report;
    return {{"known-light", "what you gain by knowing the light", report}};
}
}  // namespace bmc::beyond
