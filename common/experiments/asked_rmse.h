// What comes of asking for an RMSE (scene/pilot.h).
#pragma once

#include "experiments/picture_cost.h"

// The samples that are chosen, and the RMSE of the pictures of four seeds over what was asked: a row for each of four
// RMSEs and for a pool of every known part, down to the first that 512 samples do not have.
std::string asked_table(const EnvironmentMap& environment, const CostSettings& costs);
