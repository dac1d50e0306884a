#include "quadrature/quadrature.h"

namespace bmc {
DirectionSet place_directions(Placement placement, std::size_t n, Random& random) {
    if (placement == Placement::uniform) return {placement, uniform_directions(n, random)};
    if (placement == Placement::cosine) return {placement, cosine_directions(n, random)};
    std::vector<Vec3> directions =
        placement == Placement::fibonacci ? fibonacci_directions(n) : cosine_fibonacci_directions(n);
    const double turns = random.uniform();
    for (Vec3& direction : directions) direction = rotate_around_y(direction, turns);
    return {placement, std::move(directions)};
}

// BEGIN SOLUTION montecarlo
// Uniform directions have the density 1 / 2 pi, those distributed by the cosine cos(theta) / pi.
QuadratureRule monte_carlo_rule(DirectionSet set) {
    const bool cosine = set.placement == Placement::cosine || set.placement == Placement::cosine_fibonacci;
    const double n = static_cast<double>(set.directions.size());
    std::vector<double> weights(set.directions.size(), (cosine ? portable::pi : 2 * portable::pi) / n);
    return {std::move(set.directions), std::move(weights), cosine ? Known::cosine : Known::nothing};
}
// END SOLUTION

QuadratureRule bayesian_rule(const Covariance& covariance, double noise, std::vector<Vec3> directions, Known known) {
    const GaussianProcess process(covariance, noise, std::move(directions), known);
    return {process.directions(), process.weights(), known};
}
}  // namespace bmc
