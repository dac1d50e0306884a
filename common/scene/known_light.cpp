#include "scene/known_light.h"

#include <algorithm>
#include <optional>

namespace {

// The sums of a quotient: of all light, and of what arrives.
struct Quotient {
    Color all, visible;

    void add(Color light, bool is_visible) {
        all += light;
        if (is_visible) visible += light;
    }

    // All arrives of a colour that no ray has.
    Color operator()() const {
        const auto fraction = [](double part, double whole) { return whole > 0 ? part / whole : 1; };
        return {fraction(visible.x, all.x), fraction(visible.y, all.y), fraction(visible.z, all.z)};
    }
};

}  // namespace

std::size_t sun_samples(const PrefilteredEnvironment& light, std::size_t samples) {
    if (light.sun().empty()) return 0;
    const double half = 0.5 * light.sun().share() * static_cast<double>(samples);
    return std::max<std::size_t>(static_cast<std::size_t>(half + 0.5), 1);
}

CosineRule quotient_rule(const QuadratureRule& rule) {
    CosineRule quotient = cosine_rule(rule);
    for (WeightedDirection& each : quotient) each.weight = std::max(each.weight, 0.0);
    return quotient;
}

// No task of the practice, but near one: the hand-out leaves it out as it leaves out the tasks.

// BEGIN SOLUTION extra
std::vector<const LightTable*> caps_of(const QuadratureRule& rule, const PrefilteredEnvironment& light) {
    const double share = 2 * portable::pi / static_cast<double>(rule.weights.size());
    const CosineRule cosine = cosine_rule(rule);
    std::vector<const LightTable*> caps;
    for (std::size_t i = 0; i < cosine.size(); ++i)
        caps.push_back(&light.table(std::clamp(cosine[i].weight / rule.directions[i].y, share / 4, share * 4)));
    return caps;
}
// END SOLUTION

// BEGIN SOLUTION extra
VisibleSun visible_sun(const Scene& scene, const PrefilteredEnvironment& light, const Hit& hit, const SunRays& rays) {
    Random random = rays.random;
    Quotient fraction;
    std::optional<bool> last;
    double changes = 0;
    for (std::size_t j = 0; j < rays.count; ++j) {
        const double stratum = static_cast<double>(j) + random.uniform();
        const Sun::Ray& ray = light.sun().ray(stratum / static_cast<double>(rays.count));
        const double cosine = dot(hit.normal, ray.direction);
        if (cosine <= 0) continue;
        const bool passes = !is_shadowed(scene, hit, ray.direction);
        fraction.add(cosine * ray.colour, passes);
        changes += passes != last.value_or(passes);
        last = passes;
    }
    return {fraction(), changes};
}
// END SOLUTION

// BEGIN SOLUTION extra
Color reflected_known_light(const Scene& scene, const PrefilteredEnvironment& light, const Hit& hit,
                            const CosineRule& rule, const std::vector<const LightTable*>& caps, const Frame& frame,
                            const SunRays& sun) {
    Quotient visible_sky;
    for (std::size_t i = 0; i < rule.size(); ++i) {
        const Direction direction = frame.to_world(rule[i].direction);
        visible_sky.add(rule[i].weight * caps[i]->radiance(direction), !is_shadowed(scene, hit, direction));
    }
    const Color irradiance = light.sky_irradiance(hit.normal) * visible_sky() +
                             light.sun_irradiance(hit.normal) * visible_sun(scene, light, hit, sun).fraction;
    return 1 / portable::pi * (hit.albedo * irradiance);
}
// END SOLUTION
