// The commands of the workbench that go beyond the practice.
#pragma once

#include "beyond/known_light_cost.h"

namespace bmc::beyond {
inline std::vector<Command> commands() {
    return {command<KnownLightReport>("known-light", "what it saves to know the light")};
}
}  // namespace bmc::beyond
