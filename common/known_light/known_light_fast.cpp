#include "known_light/known_light_fast.h"

#include "scene/reflection_fast.h"

namespace bmc {
// If no ray is shadowed, both sums of the quotient are equal.
Color visible_sky_fast(const Scene& scene, const EnvironmentMap& means, const Hit& hit, const CosineRule& rule,
                       const Frame& frame) {
    const float *const x = rule.x.data(), *y = rule.y.data(), *z = rule.z.data();
    int shadowed = 0;
    of_other_object(scene, hit, [&, point = hit.point, n = rule.size()](const auto other) {
        for (std::size_t i = 0; i < n; ++i)
            shadowed |= is_shadowed_by(other, point, frame.to_world(Direction{x[i], y[i], z[i]}));
    });
    if (!shadowed) return {1, 1, 1};
    return Quotient{unshadowed_irradiance_fast(means, rule, frame), irradiance_fast(scene, means, hit, rule, frame)}
        .fraction();
}
}  // namespace bmc
