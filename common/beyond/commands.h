// The commands of the workbench that go beyond the practice.
#pragma once

#include "beyond/reports/models.h"
#include "beyond/reports/stability.h"
#include "beyond/reports/tradeoff.h"

namespace bmc::beyond {
inline std::vector<Command> commands() {
    return {command<TradeoffReport>("tradeoff", "what accuracy costs"),
            command<ModelsReport>("models", "covariances and noise compared"),
            {"stability", "where the arithmetic breaks", {}, stability_report}};
}
}  // namespace bmc::beyond
