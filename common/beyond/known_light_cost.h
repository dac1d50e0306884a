// What it saves to know the light.
#pragma once

#include "beyond/predicted_error.h"
#include "experiments/reports.h"

namespace bmc::beyond {
// What renderers do with a light that they know: half of the samples are drawn in proportion to the light (the sun of
// threshold 0) and stratified, the others are the directions of a rule of these settings, of density cos(theta) / pi.
// Each is weighted by the balance heuristic of multiple importance sampling (Veach & Guibas, cited in sun.h). Where the
// light is known, the sum is divided by itself without shadows and multiplied by E(n) (Heitz, Hill & McGuire,
// "Combining analytic direct illumination and stochastic shadows", I3D 2018). The map and the sun must outlive it.
Shader mis_shader(const EnvironmentLight& light, const Sun& all, RenderSettings settings);

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
