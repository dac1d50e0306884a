#include "scene/reflection_fast.h"

#include <algorithm>

namespace bmc {
// A texel and the float behind it, which one instruction loads and widens.
typedef double Double4 __attribute__((vector_size(32)));

constexpr std::size_t batch = 256;  // rays

// First the texels of a batch of rays; a shadowed ray has the black one behind the map. Iterations of that loop are
// independent. Then the sum, in the order of the plain loop; its texels are on their way from memory by then.
template <class Shadowed>
Color sum(const EnvironmentMap& environment, const CosineRule& rule, const Frame& frame, Shadowed shadowed) {
    const float *const texels = environment.texels(), *x = rule.x.data(), *y = rule.y.data(), *z = rule.z.data();
    const TexelGrid grid = environment.grid();
    const int black = grid.width() * grid.height();
    Double4 irradiance{};
    for (std::size_t begin = 0; begin < rule.size(); begin += batch) {
        const std::size_t end = std::min(begin + batch, rule.size());
        const std::size_t padded_end = begin + (end - begin + 7) / 8 * 8;
        int texel[batch];
        for (std::size_t i = begin; i < padded_end; ++i) {
            const Direction direction = frame.to_world(Direction{x[i], y[i], z[i]});
            const int seen = grid.texel_index(direction.x, direction.y, direction.z);
            texel[i - begin] = 3 * (shadowed(direction) ? black : seen);
        }
        for (std::size_t i = begin; i < end; ++i) __builtin_prefetch(texels + texel[i - begin]);
        for (std::size_t i = begin; i < end; ++i) {
            const float* t = texels + texel[i - begin];
            irradiance += rule.weights[i] * Double4{t[0], t[1], t[2], t[3]};
        }
    }
    return {irradiance[0], irradiance[1], irradiance[2]};
}

Color irradiance_fast(const Scene& scene, const EnvironmentMap& environment, const Hit& hit, const CosineRule& rule,
                      const Frame& frame) {
    return of_other_object(scene, hit, [&, point = hit.point](const auto other) {
        return sum(environment, rule, frame, [=](Direction d) { return is_shadowed_by(other, point, d); });
    });
}

Color unshadowed_irradiance_fast(const EnvironmentMap& environment, const CosineRule& rule, const Frame& frame) {
    return sum(environment, rule, frame, [](Direction) { return false; });
}

Color reflected_light_fast(const Scene& scene, const EnvironmentMap& environment, const Hit& hit,
                           const CosineRule& rule, const Frame& frame) {
    return 1 / portable::pi * (hit.albedo * irradiance_fast(scene, environment, hit, rule, frame));
}
}  // namespace bmc
