#include "scene/pixel_rules.h"

#include <stdexcept>

namespace bmc {
PixelRules::PixelRules(const RenderSettings& picture_settings)
    : settings(picture_settings),
      covariance(settings.method == Method::mc ? nullptr : settings.make_covariance()),
      sampler(sampler_of(settings.placement, settings.samples)),
      shared(shared_count() > 0 ? shared_rules() : SharedRules{}) {}

// Rules of a fixed set differ by a rotation alone, so that one will do.
std::size_t PixelRules::shared_count() const {
    const bool fixed = settings.placement.is_fixed();
    if (settings.method == Method::direct || (settings.method == Method::mc && !fixed)) return 0;
    return settings.method == Method::pool && !fixed ? settings.pool : 1;
}

// The shared_count() rules, made once: rule i by fresh_rule and rule_stream(settings, i).
// BEGIN SOLUTION shared_rules
SharedRules PixelRules::shared_rules() const {
    SharedRules rules;
    Progress progress("rules", shared_count());
    for (std::size_t i = 0; i < shared_count(); ++i) {
        Random random = rule_stream(settings, i);
        rules.push_back(fresh_rule(random));
        progress.done();
    }
    return rules;
}
// END SOLUTION

std::shared_ptr<const QuadratureRule> PixelRules::fresh_rule(Random& random) const {
    std::vector<Vec3> directions = sampler(random);
    return std::make_shared<QuadratureRule>(
        cosine_rule(settings.method == Method::mc ? monte_carlo_rule(std::move(directions), settings.placement.density)
                                                  : bayesian_rule(*covariance, settings.noise, std::move(directions))));
}

OrientedRule PixelRules::rule_for(Vec3 normal, Random& random) const {
    const Frame frame(normal);
    switch (settings.method) {
        case Method::mc:
            if (shared.empty()) return {frame, fresh_rule(random)};
            return {frame.rotated(random.uniform()), shared[0]};
        case Method::direct: {
            // BEGIN SOLUTION rule_for
            return {frame, fresh_rule(random)};
            // END SOLUTION
        }
        case Method::single: {
            // BEGIN SOLUTION rule_for
            return {frame, shared[0]};
            // END SOLUTION
        }
        case Method::rotated: {
            // BEGIN SOLUTION rule_for
            return {frame.rotated(random.uniform()), shared[0]};
            // END SOLUTION
        }
        case Method::pool: {
            // The first random number u chooses rule floor(u n) of n, and the second one rotates it.
            // BEGIN SOLUTION rule_for
            const double u = random.uniform();
            const auto chosen = static_cast<std::size_t>(u * static_cast<double>(shared.size()));
            return {frame.rotated(random.uniform()), shared[chosen]};
            // END SOLUTION
        }
    }
    throw std::logic_error("rule_for has no case for this method");
}
}  // namespace bmc
