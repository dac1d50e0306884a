// The commands of the workbench that go beyond the practice.
#pragma once

#include "beyond/known_light_cost.h"

namespace bmc::beyond {
inline std::vector<Command> commands() {
    return {{"known-light", "what it saves to know the light", std::make_shared<KnownLightReport>()}};
}
}  // namespace bmc::beyond
