// The integrals that a renderer estimates: what the experiments on models ask of a covariance.
#pragma once

#include "experiments/integrands.h"

// Incident luminance times cos(theta), shadows included, at so many points that pixels of the sphere scene show, drawn
// at random. Truths are dense quadratures.
std::vector<Integrand> scene_integrands(const std::shared_ptr<const EnvironmentMap>& light, std::size_t points);
