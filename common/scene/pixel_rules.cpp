#include "scene/pixel_rules.h"

#include <algorithm>

Random pixel_stream(const RenderSettings& settings, int x, int y) {
    return {settings.seed,
            static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(settings.width) + static_cast<std::uint64_t>(x)};
}

PixelRules::PixelRules(const RenderSettings& settings, const PrefilteredEnvironment* averages)
    : settings_(settings),
      averages_(averages),
      covariance_(settings.make_covariance()),
      sun_samples_(averages ? ::sun_samples(*averages, settings.samples) : 0) {
    settings_.samples = std::max<std::size_t>(settings.samples - sun_samples_, 1);
}

std::size_t PixelRules::shared_count() const {
    if (settings_.method == Method::pool) return settings_.pool;
    const bool turned = settings_.method == Method::mc && is_lattice(settings_.placement);
    return turned || settings_.method == Method::single || settings_.method == Method::rotated ? 1 : 0;
}

void PixelRules::make_shared_rule() {
    constexpr std::uint64_t first_stream = std::uint64_t{1} << 63;
    Random random(settings_.seed, first_stream + shared_rules_.size());
    shared_rules_.push_back(fresh_rule(settings_.samples, random));
}

std::shared_ptr<const PixelRule> PixelRules::fresh_rule(std::size_t samples, Random& random) const {
    DirectionSet set = place_directions(settings_.placement, samples, random);
    PixelRule pixel_rule;
    QuadratureRule rule;
    if (settings_.method == Method::mc) {
        rule = monte_carlo_rule(std::move(set));
    } else {
        GaussianProcess process(*covariance_, settings_.noise, std::move(set.directions), settings_.prior);
        rule = {process.directions(), process.weights(), settings_.prior.known};
        if (settings_.show == Show::error) pixel_rule.process = std::move(process);
    }
    pixel_rule.rule = averages_ ? quotient_rule(rule) : cosine_rule(rule);
    if (averages_) pixel_rule.caps = caps_of(rule, *averages_);
    return std::make_shared<const PixelRule>(std::move(pixel_rule));
}

// BEGIN SOLUTION direct
// A Gaussian process for every integral, on fresh directions from the pixel's random numbers.
PlacedRule PixelRules::direct(Vec3 normal, Random& random) const {
    const std::shared_ptr<const PixelRule> rule = fresh_rule(settings_.samples, random);
    return {rule, Frame(normal)};
}
// END SOLUTION

// BEGIN SOLUTION single
// One process for the whole image, shared_rules_[0], its up axis aligned with the normal.
PlacedRule PixelRules::single(Vec3 normal) const {
    const Frame aligned(normal);
    return {shared_rules_[0], aligned};
}
// END SOLUTION

// BEGIN SOLUTION rotated
// The same, but turned about its up axis by the pixel's own random angle before it is aligned with the normal.
PlacedRule PixelRules::rotated(Vec3 normal, double turns) const {
    const Frame turned = Frame(normal).rotated(turns);
    return {shared_rules_[0], turned};
}
// END SOLUTION

// BEGIN SOLUTION pool
// A random one of several processes, shared_rules_, turned like the one; u is uniform in [0, 1).
PlacedRule PixelRules::pool(Vec3 normal, double u, double turns) const {
    const auto choice = static_cast<std::size_t>(u * static_cast<double>(shared_rules_.size()));
    const Frame turned = Frame(normal).rotated(turns);
    return {shared_rules_[choice], turned};
}
// END SOLUTION

PlacedRule PixelRules::of(Vec3 normal, Random& random) const {
    PlacedRule placed = without_sun(normal, random);
    if (sun_samples_ > 0) placed.sun = {sun_samples_, random};
    return placed;
}

PlacedRule PixelRules::without_sun(Vec3 normal, Random& random) const {
    if (settings_.method == Method::direct) return direct(normal, random);
    if (settings_.method == Method::single) return single(normal);
    if (shared_rules_.empty()) return {fresh_rule(settings_.samples, random), Frame(normal)};
    const double u = random.uniform();
    const double turns = random.uniform();
    return settings_.method == Method::pool ? pool(normal, u, turns) : rotated(normal, turns);
}
