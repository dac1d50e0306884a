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
    Known known = Known::nothing;  // p

    std::size_t size() const { return weights.size(); }
};

// Monte Carlo: the estimate of the integral of f p is the mean of f p / density. If p has the shape of the density,
// that is f times the integral of p. So the weights are equal: 2 pi / n for p = 1, and pi / n for p = cos(theta)
// (importance sampling). On a lattice this is quasi-Monte Carlo.
QuadratureRule monte_carlo_rule(std::vector<Vec3> directions, Density density = Density::uniform);

// Bayesian Monte Carlo: the weights of a GaussianProcess. Throws what GaussianProcess throws.
QuadratureRule bayesian_rule(const Covariance& covariance, double noise, std::vector<Vec3> directions);

// The same rule with the known part cos(theta), which a picture needs: it integrates f cos(theta) from samples of f.
// The cosine goes into the weights, unless it is there already.
QuadratureRule cosine_rule(QuadratureRule rule);

// A picture takes the integral of L cos(theta), with the weights W_j of the cosine_rule. Two worlds show what they do.
// A white world, L = 1, gets the brightness B = sum of W_j / pi in place of 1; the error of Monte Carlo is 1 / sqrt(3
// N) there. In a world of noise the samples are independent, and the variance of the estimate is theirs times the sum
// of W_j^2; for Monte Carlo this sum is 4 pi^2 / (3 N). The noise gain is the root of the ratio of both sums. Above 2,
// weights of both signs cancel (Karvonen, Kanagawa & Sarkka, "On the positivity and magnitudes of Bayesian quadrature
// weights", Statistics and Computing 2019), and pictures are usually worse than Monte Carlo's.
double white_brightness(const QuadratureRule& rule);
double noise_gain(const QuadratureRule& rule);
}  // namespace bmc
