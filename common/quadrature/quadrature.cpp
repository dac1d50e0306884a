#include "quadrature/quadrature.h"

#include "quadrature/gaussian_process.h"

namespace bmc {
// BEGIN SOLUTION montecarlo
QuadratureRule monte_carlo_rule(std::vector<Vec3> directions, Density density) {
    const std::size_t n = directions.size();
    const bool knows_cosine = density == Density::cosine;
    const double weight = known_integral(knows_cosine) / static_cast<double>(n);
    return {std::move(directions), std::vector<double>(n, weight), knows_cosine};
}
// END SOLUTION

QuadratureRule bayesian_rule(const Covariance& covariance, double noise, std::vector<Vec3> directions) {
    GaussianProcess process(covariance, noise, std::move(directions));
    return {std::move(process.directions), std::move(process.weights), covariance.knows_cosine()};
}

// BEGIN SOLUTION shade
QuadratureRule cosine_rule(QuadratureRule rule) {
    if (!rule.knows_cosine)
        for (std::size_t i = 0; i < rule.size(); ++i) rule.weights[i] *= rule.directions[i].y;
    rule.knows_cosine = true;
    return rule;
}
// END SOLUTION
}  // namespace bmc
