#include "scene/pixel_rules.h"

namespace bmc {
namespace {

// How many rules pixels share.
std::size_t shared_count(const RenderSettings& settings) {
    if (settings.method == Method::pool) return settings.pool;
    if (settings.method == Method::mc) return is_lattice(settings.placement) ? 1 : 0;
    return settings.method == Method::direct ? 0 : 1;
}

}  // namespace

Random pixel_stream(const RenderSettings& settings, int x, int y) {
    return {settings.seed,
            static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(settings.width) + static_cast<std::uint64_t>(x)};
}

PixelRules::PixelRules(const RenderSettings& settings) : settings_(settings), covariance_(settings.make_covariance()) {
    constexpr std::uint64_t first_stream = std::uint64_t{1} << 63;
    for (std::size_t i = 0; i < shared_count(settings); ++i) {
        Random random(settings.seed, first_stream + i);
        rules_.push_back(fresh_rule(random));
    }
    for (const CosineRule& rule : rules_) shared_rules_.emplace_back(std::shared_ptr<void>(), &rule);
}

CosineRule PixelRules::fresh_rule(Random& random) const {
    DirectionSet set = place_directions(settings_.placement, settings_.samples, random);
    return cosine_rule(settings_.method == Method::mc
                           ? monte_carlo_rule(std::move(set))
                           : bayesian_rule(*covariance_, settings_.noise, std::move(set.directions), settings_.known));
}

// BEGIN SOLUTION direct
// A Gaussian process for every integral, on fresh directions from the pixel's random numbers.
PlacedRule PixelRules::direct(Vec3 normal, Random& random) const {
    const auto rule = std::make_shared<const CosineRule>(fresh_rule(random));
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

PlacedRule PixelRules::rule_for(Vec3 normal, Random& random) const {
    if (settings_.method == Method::direct) return direct(normal, random);
    if (settings_.method == Method::single) return single(normal);
    if (shared_rules_.empty()) return direct(normal, random);
    const double u = random.uniform();
    const double turns = random.uniform();
    return settings_.method == Method::pool ? pool(normal, u, turns) : rotated(normal, turns);
}
}  // namespace bmc
