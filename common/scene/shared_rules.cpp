#include "scene/pixel_rules.h"

namespace bmc {
std::size_t shared_count(const RenderSettings& settings) {
    switch (settings.method) {
        case Method::mc: return settings.placement.arrangement == Arrangement::lattice ? 1 : 0;
        case Method::direct: return 0;
        case Method::single:
        case Method::rotated: return 1;
        case Method::pool: return settings.pool;
    }
    throw std::logic_error("a method without rules");
}

// The shared_count(settings) rules, made once: rule i by fresh_rule and rule_stream(settings, i).
// BEGIN SOLUTION shared_rules
SharedRules PixelRules::shared_rules() const {
    SharedRules rules;
    Progress progress(shared_count(settings));
    for (std::size_t i = 0; i < shared_count(settings); ++i) {
        Random random = rule_stream(settings, i);
        rules.push_back(fresh_rule(random));
        progress.done();
    }
    return rules;
}
// END SOLUTION
}  // namespace bmc
