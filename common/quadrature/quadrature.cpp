#include "quadrature/quadrature.h"

namespace bmc {
std::string Placement::name() const {
    const std::string of_uniform = point_set_names[static_cast<std::size_t>(set)];
    if (density == KnownPart::nothing) return of_uniform;
    return set == PointSet::random ? "cosine" : "cosine-" + of_uniform;
}

std::vector<Placement> all_placements() {
    std::vector<Placement> all;
    for (const KnownPart density : {KnownPart::nothing, KnownPart::cosine})
        for (std::size_t i = 0; i < std::size(point_set_names); ++i) all.push_back({static_cast<PointSet>(i), density});
    return all;
}

static Sampler rotated(const std::vector<Vec3>& fixed) {
    return [=](Random& random) {
        std::vector<Vec3> directions = fixed;
        const double turns = random.uniform();
        for (Vec3& direction : directions) direction = rotate_around_y(direction, turns);
        return directions;
    };
}

Sampler sampler_of(Placement placement, std::size_t n) {
    const KnownPart p = placement.density;
    switch (placement.set) {
        case PointSet::random: return [=](Random& random) { return random_directions(n, random, p); };
        case PointSet::stratified: return [=](Random& random) { return stratified_directions(n, random, p); };
        case PointSet::fibonacci: return rotated(fibonacci_directions(n, p));
        case PointSet::optimised: break;
    }
    return rotated(optimised_directions(n, p));
}

// BEGIN SOLUTION montecarlo
QuadratureRule monte_carlo_rule(std::vector<Vec3> directions, KnownPart p) {
    const std::size_t n = directions.size();
    const double weight = known_integral(p) / static_cast<double>(n);
    return {std::move(directions), std::vector<double>(n, weight), p};
}
// END SOLUTION

QuadratureRule bayesian_rule(const Covariance& covariance, double noise, std::vector<Vec3> directions) {
    GaussianProcess process(covariance, noise, std::move(directions));
    return {std::move(process.directions), std::move(process.weights), covariance.known_part()};
}

std::shared_ptr<const Covariance> ModelSettings::make_covariance() const {
    const bool in_closed_form = covariance == CovarianceFamily::sobolev && smoothness == 1.5;
    if (known_part.value_or(placement.density) == KnownPart::cosine) {
        if (in_closed_form) return std::make_shared<SobolevKnownCosine>();
        throw std::invalid_argument(
            "the known part cosine, as of directions of that density, needs the covariance sobolev of smoothness 1.5");
    }
    if (in_closed_form) return std::make_shared<Sobolev>();
    switch (covariance) {
        case CovarianceFamily::sobolev: return std::make_shared<GeneralSobolev>(smoothness);
        case CovarianceFamily::squared_exponential: return std::make_shared<SquaredExponential>(length_scale);
    }
    throw std::logic_error("a covariance has a name and no class");
}

// BEGIN SOLUTION shade
QuadratureRule cosine_rule(QuadratureRule rule) {
    if (rule.known_part == KnownPart::nothing)
        for (std::size_t i = 0; i < rule.size(); ++i) rule.weights[i] *= rule.directions[i].y;
    rule.known_part = KnownPart::cosine;
    return rule;
}
// END SOLUTION

// W_j. Not by cosine_rule, which students write: assignment 3.1 prints these numbers before that.
static double weight_in_picture(const QuadratureRule& rule, std::size_t j) {
    return rule.weights[j] * (rule.known_part == KnownPart::cosine ? 1 : rule.directions[j].y);
}

double white_brightness(const QuadratureRule& rule) {
    double sum = 0;
    for (std::size_t j = 0; j < rule.size(); ++j) sum += weight_in_picture(rule, j);
    return sum / portable::pi;
}

double noise_gain(const QuadratureRule& rule) {
    double squares = 0;
    for (std::size_t j = 0; j < rule.size(); ++j) squares += weight_in_picture(rule, j) * weight_in_picture(rule, j);
    return std::sqrt(3 * static_cast<double>(rule.size()) * squares) / (2 * portable::pi);
}
}  // namespace bmc
