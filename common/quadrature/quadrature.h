// Quadrature rules over the hemisphere H: what Monte Carlo and Bayesian Monte Carlo have in common. Code that applies a
// rule need not know where its weights come from.
#pragma once

#include "quadrature/gaussian_process.h"
#include "quadrature/hemisphere.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace bmc {
// The integral of f p over H, w.r.t. solid angle, is about the sum of weights[i] * f(directions[i]), where p is the
// known part: 1, or cos(theta). Rotating the directions about the up axis gives an equally good rule.
struct QuadratureRule {
    std::vector<Vec3> directions;
    std::vector<double> weights;
    KnownPart known_part = KnownPart::nothing;

    std::size_t size() const { return weights.size(); }
};

// How the directions of a rule are placed: a set (hemisphere.h), of a density that is the known part divided by its
// integral.
enum class PointSet { random, stratified, fibonacci, optimised };
inline constexpr const char* point_set_names[] = {"uniform", "stratified", "fibonacci", "optimised"};
struct Placement {
    PointSet set = PointSet::random;
    KnownPart density = KnownPart::nothing;

    // Whether all sets are one, but for a rotation: a lattice, or an optimised set.
    bool is_fixed() const { return set != PointSet::random && set != PointSet::stratified; }

    std::string name() const;  // uniform, cosine, stratified, cosine-stratified, ...
};
std::vector<Placement> all_placements();

// Draws a fresh set of n >= 1 directions. A fixed set is made once, here, and then rotated by random angles.
using Sampler = std::function<std::vector<Vec3>(Random&)>;
Sampler sampler_of(Placement placement, std::size_t n);

// Monte Carlo: the estimate of the integral of f p is the mean of f p / density, which is f times the integral of p. So
// the weights are equal: 2 pi / n for p = 1, and pi / n for p = cos(theta) (importance sampling). On a lattice this is
// quasi-Monte Carlo.
QuadratureRule monte_carlo_rule(std::vector<Vec3> directions, KnownPart p = KnownPart::nothing);

// Bayesian Monte Carlo: the weights of a GaussianProcess. Throws what GaussianProcess throws.
QuadratureRule bayesian_rule(const Covariance& covariance, double noise, std::vector<Vec3> directions);

// The same rule with the known part cos(theta), which a picture needs: it integrates f cos(theta) from samples of f.
// The cosine goes into the weights, unless it is there already.
QuadratureRule cosine_rule(QuadratureRule rule);

// Add a covariance here and to the table; the compiler then asks for its case in make_covariance.
enum class CovarianceFamily { sobolev, squared_exponential };
inline constexpr const char* covariance_names[] = {"sobolev", "squared-exponential"};

// Settings of a rule, except its number of directions.
struct ModelSettings {
    CovarianceFamily covariance = CovarianceFamily::sobolev;
    double smoothness = 1.5;  // of sobolev
    double length_scale = 1;  // of any other family
    double noise = 0.01;
    std::optional<KnownPart> known_part = {};  // unless given, the density of the placement
    Placement placement = {};
    std::uint64_t seed = 1;

    // Throws std::invalid_argument as the covariance's constructor does, and if the known part has no closed form.
    std::shared_ptr<const Covariance> make_covariance() const;
};

// A picture takes the integral of L cos(theta), with the weights W_j of the cosine_rule. Two worlds show what they do.
// A white world, L = 1, gets the brightness B = sum of W_j / pi in place of 1; the error of Monte Carlo is 1 / sqrt(3
// N) there. In a world of noise the samples are independent, and the variance of the estimate is theirs times the sum
// of W_j^2; for Monte Carlo this sum is 4 pi^2 / (3 N). The noise gain is the root of the ratio of both sums. Above 2,
// weights of both signs cancel (Karvonen, Kanagawa & Sarkka, "On the positivity and magnitudes of Bayesian quadrature
// weights", Statistics and Computing 2019), and pictures are usually worse than Monte Carlo's.
double white_brightness(const QuadratureRule& rule);
double noise_gain(const QuadratureRule& rule);
}  // namespace bmc
