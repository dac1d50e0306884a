// What it saves to know the light.
#pragma once

#include "beyond/predicted_error.h"
#include "experiments/reports.h"

namespace bmc::beyond {
// What renderers do with a light that they know: half of the samples are drawn in proportion to the light
// (the sun of threshold 0), the others to the cosine, both stratified, and each is weighted by the balance heuristic of
// multiple importance sampling (Veach & Guibas, cited in sun.h). The map and the light must outlive the shader.
Shader mis_shader(const EnvironmentMap& map, const Sun& light, const RenderSettings& settings);

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
