// What a pixel of the sphere scene integrates.
#pragma once

#include "experiments/integrands.h"

#include <vector>

// Incident luminance times cos(theta), shadows included, at five points of the sphere scene in the built-in
// environment: three on the sphere, two on the rectangle.
std::vector<Integrand> scene_integrands();
