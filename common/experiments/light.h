// The built-in environment for other programs.
#pragma once

#include "numerics/portable_math.h"

#include "experiments/command.h"

// Writes a Radiance picture (.hdr): other programs can light the sphere scene with it.
struct LightFile {
    std::vector<Option> options() { return {}; }
    std::string report() const;
};
