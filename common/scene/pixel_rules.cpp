#include "scene/pixel_rules.h"

namespace bmc {
Random pixel_stream(const RenderSettings& settings, int x, int y) {
    return {settings.seed, static_cast<std::uint64_t>(std::int64_t{y} * settings.width + x)};
}

// The stream of shared rule i; pixels have the streams from 0.
static Random rule_stream(const RenderSettings& settings, std::size_t i) {
    return {settings.seed, (std::uint64_t{1} << 63) + i};
}

// The number of rules that pixels share.
static std::size_t shared_count(const RenderSettings& settings) {
    switch (settings.method) {
        case Method::mc: return is_lattice(settings.placement) ? 1 : 0;
        case Method::direct: return 0;
        case Method::single:
        case Method::rotated: return 1;
        case Method::pool: return settings.pool;
    }
    throw std::logic_error("a method without rules");
}

PixelRules::PixelRules(const RenderSettings& settings) : settings_(settings) {
    if (settings.method != Method::mc) covariance_ = settings.make_covariance();
    if (shared_count(settings) > 0) shared_ = shared_rules();  // mc renders before that task is written
    std::vector<QuadratureRule> examined = shared_;
    if (examined.empty()) {
        Random random = rule_stream(settings, 0);
        examined.push_back(fresh_rule(random));
    }
    for (const QuadratureRule& rule : examined) {
        stability_ += stability_constant(rule) / static_cast<double>(examined.size());
        weight_sum_ += relative_weight_sum(rule) / static_cast<double>(examined.size());
    }
    for (QuadratureRule& rule : shared_) rule = cosine_rule(std::move(rule));
}

// The shared_count(settings_) rules, made once: rule i by fresh_rule and rule_stream(settings_, i), without cos(theta).
// BEGIN SOLUTION shared_rules
std::vector<QuadratureRule> PixelRules::shared_rules() const {
    std::vector<QuadratureRule> rules;
    for (std::size_t i = 0; i < shared_count(settings_); ++i) {
        Random random = rule_stream(settings_, i);
        rules.push_back(fresh_rule(random));
    }
    return rules;
}
// END SOLUTION

QuadratureRule PixelRules::fresh_rule(Random& random) const {
    DirectionSet set = place_directions(settings_.placement, settings_.samples, random);
    if (settings_.method == Method::mc) return monte_carlo_rule(std::move(set));
    return bayesian_rule(*covariance_, settings_.noise, std::move(set.directions));
}

PlacedRule PixelRules::rule_for(Vec3 normal, Random& random) const {
    const Frame frame(normal);
    switch (settings_.method) {
        case Method::mc:
            if (shared_.empty()) return {frame, cosine_rule(fresh_rule(random))};
            return {frame.rotated(random.uniform()), {}, &shared_[0]};
        case Method::direct:
            // BEGIN SOLUTION rule_for
            return {frame, cosine_rule(fresh_rule(random))};
            // END SOLUTION
        case Method::single:
            // BEGIN SOLUTION rule_for
            return {frame, {}, &shared_[0]};
            // END SOLUTION
        case Method::rotated:
            // BEGIN SOLUTION rule_for
            return {frame.rotated(random.uniform()), {}, &shared_[0]};
            // END SOLUTION
        case Method::pool:
            // BEGIN SOLUTION rule_for
            const double u = random.uniform();  // chooses the rule; a second number turns it
            const auto chosen = static_cast<std::size_t>(u * static_cast<double>(shared_.size()));
            return {frame.rotated(random.uniform()), {}, &shared_[chosen]};
            // END SOLUTION
    }
    throw std::logic_error("a method without a rule");
}
}  // namespace bmc
