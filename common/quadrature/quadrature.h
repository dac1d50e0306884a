// Quadrature rules over the hemisphere: what Monte Carlo and Bayesian Monte Carlo have in common. To apply a rule, one
// need not know where its weights come from.
#pragma once

#include "quadrature/gaussian_process.h"
#include "quadrature/hemisphere.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace bmc {
// The integral of f p over H, w.r.t. solid angle, is about the sum of weights[i] * f(directions[i]), where p is the
// known part: 1, or cos(theta). Rotating the directions about the up axis gives a rule of the same quality.
struct QuadratureRule {
    std::vector<Vec3> directions;
    std::vector<double> weights;
    Known known = Known::nothing;
};

// p(direction).
inline double known_part(Known known, Vec3 direction) { return known == Known::nothing ? 1 : direction.y; }

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

struct DirectionSet {
    Placement placement;
    std::vector<Vec3> directions;
};

// A fresh set of n >= 1 directions: independent ones, or the lattice turned by a random angle.
DirectionSet place_directions(Placement placement, std::size_t n, Random& random);

// Monte Carlo: all weights are equal. Directions with density cos(theta) / pi have cos(theta) as the known part: that
// is importance sampling of f cos(theta). On a lattice it is quasi-Monte Carlo.
QuadratureRule monte_carlo_rule(DirectionSet set);

// Bayesian Monte Carlo: the weights of a GaussianProcess; throws as it does.
QuadratureRule bayesian_rule(const Covariance& covariance, double noise, std::vector<Vec3> directions,
                             Known known = Known::nothing);

// Settings of a rule, except its number of directions.
struct ModelSettings {
    CovarianceFamily covariance = CovarianceFamily::sobolev;
    double smoothness = 1.5;  // of the family sobolev
    double length_scale = 1;  // of the other
    double noise = 0.01;
    Known known = Known::nothing;
    Placement placement = Placement::uniform;
    std::uint64_t seed = 1;

    // Throws std::invalid_argument as the covariance's constructor does.
    std::unique_ptr<Covariance> make_covariance() const {
        return bmc::make_covariance(covariance, covariance == CovarianceFamily::sobolev ? smoothness : length_scale);
    }
};
}  // namespace bmc
