#include "quadrature.h"

#include "gaussian_process.h"

std::vector<Vec3> place_directions(Placement placement, std::size_t n, Random& random) {
    if (placement == Placement::uniform) return uniform_directions(n, random);
    std::vector<Vec3> directions = fibonacci_directions(n);
    const double turns = random.uniform();
    for (Vec3& direction : directions) direction = rotate_around_y(direction, turns);
    return directions;
}

QuadratureRule monte_carlo_rule(std::vector<Vec3> directions) {
    const std::size_t n = directions.size();
    return {std::move(directions), std::vector<double>(n, 2 * portable::pi / static_cast<double>(n))};
}

QuadratureRule bayesian_rule(const Covariance& covariance, double noise, std::vector<Vec3> directions) {
    const GaussianProcess process(covariance, noise, std::move(directions));
    return {process.directions(), process.weights()};
}
