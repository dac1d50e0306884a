// Quadrature rules over the hemisphere: what Monte Carlo and Bayesian Monte Carlo have in common. Whoever applies a
// rule need not know where its weights come from.
#pragma once

#include "quadrature/gaussian_process.h"
#include "quadrature/hemisphere.h"

#include <vector>

// The integral of f p over H, w.r.t. solid angle, is about the sum of weights[i] * f(directions[i]), where p is the
// known part: 1, or cos(theta). Rotating the directions about the up axis gives a rule of the same quality: the
// covariances see distances only, and the rotation leaves cos(theta) alone.
struct QuadratureRule {
    std::vector<Vec3> directions;
    std::vector<double> weights;
    KnownPart known = KnownPart::nothing;
};

// p(direction).
inline double known_part(KnownPart known, Vec3 direction) { return known == KnownPart::cosine ? direction.y : 1; }

// How the directions of a rule are placed: at random or on the Fibonacci lattice, uniformly w.r.t. solid angle or with
// density cos(theta) / pi.
enum class Placement { uniform, fibonacci, cosine, cosine_fibonacci };
constexpr std::pair<const char*, Placement> placement_names[] = {{"uniform", Placement::uniform},
                                                                 {"fibonacci", Placement::fibonacci},
                                                                 {"cosine", Placement::cosine},
                                                                 {"cosine-fibonacci", Placement::cosine_fibonacci}};

inline bool is_lattice(Placement placement) {
    return placement == Placement::fibonacci || placement == Placement::cosine_fibonacci;
}

// A fresh set of n >= 1 directions: independent ones, or the lattice turned by a random angle.
std::vector<Vec3> place_directions(Placement placement, std::size_t n, Random& random);

// Monte Carlo: n directions placed in this way count alike. Cosine-distributed ones bring cos(theta) as the known part:
// importance sampling of f cos(theta). Lattices: quasi-Monte Carlo.
QuadratureRule monte_carlo_rule(std::vector<Vec3> directions, Placement placement = Placement::uniform);

// Bayesian Monte Carlo: the weights of a GaussianProcess; throws as it does.
QuadratureRule bayesian_rule(const Covariance& covariance, double noise, std::vector<Vec3> directions,
                             Prior prior = {});
