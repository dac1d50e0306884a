// Quadrature rules over the hemisphere H: what Monte Carlo and Bayesian Monte Carlo have in common. Code that applies a
// rule need not know where its weights come from.
#pragma once

#include "quadrature/covariance.h"

namespace bmc {
// The integral of f p over H, w.r.t. solid angle, is about the sum of weights[i] * f(directions[i]), where p is the
// known part: 1, or cos(theta). Rotating the directions about the up axis gives an equally good rule.
struct QuadratureRule {
    std::vector<Vec3> directions;
    std::vector<double> weights;
    bool knows_cosine = false;

    std::size_t size() const { return weights.size(); }
};

// Monte Carlo: the estimate of the integral of f p is the mean of f p / density, which is f times the integral of p. So
// the weights are equal: 2 pi / n for p = 1, and pi / n for p = cos(theta) (importance sampling). On a lattice this is
// quasi-Monte Carlo.
QuadratureRule monte_carlo_rule(std::vector<Vec3> directions, Density density = Density::uniform);

// Bayesian Monte Carlo: the weights of a GaussianProcess. Throws what GaussianProcess throws.
QuadratureRule bayesian_rule(const Covariance& covariance, double noise, std::vector<Vec3> directions);

// The same rule with the known part cos(theta), which a picture needs: it integrates f cos(theta) from samples of f.
// The cosine goes into the weights, unless it is there already.
QuadratureRule cosine_rule(QuadratureRule rule);
}  // namespace bmc
