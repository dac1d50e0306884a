// Quadrature rules over the hemisphere: what Monte Carlo and Bayesian Monte Carlo have in common. Whoever applies a
// rule need not know where its weights come from.
#pragma once

#include "covariance.h"
#include "hemisphere.h"

#include <vector>

// The integral of f over H, w.r.t. solid angle, is about the sum of weights[i] * f(directions[i]). Rotating the
// directions about the up axis gives a rule of the same quality: the covariances see distances only.
struct QuadratureRule {
    std::vector<Vec3> directions;
    std::vector<double> weights;
};

// How the directions of a rule are placed.
enum class Placement { uniform, fibonacci };

// A fresh set of n >= 1 directions: independent and uniform, or the spherical Fibonacci set turned by a random angle.
std::vector<Vec3> place_directions(Placement placement, std::size_t n, Random& random);

// Classic Monte Carlo on uniformly distributed directions: every weight is 2 pi / n.
QuadratureRule monte_carlo_rule(std::vector<Vec3> directions);

// Bayesian Monte Carlo: weights Q^-1 z. Throws as GaussianProcess does.
QuadratureRule bayesian_rule(const Covariance& covariance, double noise, std::vector<Vec3> directions);
