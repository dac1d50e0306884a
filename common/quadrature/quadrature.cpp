#include "quadrature/quadrature.h"

std::vector<Vec3> place_directions(Placement placement, std::size_t n, Random& random) {
    if (placement == Placement::uniform) return uniform_directions(n, random);
    if (placement == Placement::cosine) return cosine_directions(n, random);
    std::vector<Vec3> directions =
        placement == Placement::fibonacci ? fibonacci_directions(n) : cosine_fibonacci_directions(n);
    const double turns = random.uniform();
    for (Vec3& direction : directions) direction = rotate_around_y(direction, turns);
    return directions;
}

// BEGIN SOLUTION montecarlo
// Uniform directions have the density 1 / 2 pi, those distributed by the cosine cos(theta) / pi.
QuadratureRule monte_carlo_rule(std::vector<Vec3> directions, Placement placement) {
    const bool cosine = placement == Placement::cosine || placement == Placement::cosine_fibonacci;
    const double n = static_cast<double>(directions.size());
    std::vector<double> weights(directions.size(), (cosine ? portable::pi : 2 * portable::pi) / n);
    return {std::move(directions), std::move(weights), cosine ? KnownPart::cosine : KnownPart::nothing};
}
// END SOLUTION

QuadratureRule bayesian_rule(const Covariance& covariance, double noise, std::vector<Vec3> directions, Prior prior) {
    const GaussianProcess process(covariance, noise, std::move(directions), prior);
    return {process.directions(), process.weights(), prior.known};
}
