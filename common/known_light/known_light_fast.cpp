#include "known_light/known_light_fast.h"

#include <algorithm>

namespace bmc {
// A texel and the float behind it, which one instruction loads and widens.
typedef double Double4 __attribute__((vector_size(32)));

constexpr std::size_t batch = 256;  // rays

// If no ray is shadowed, both sums of the quotient are equal. Otherwise the texels of a batch of rays come first, in a
// loop with independent iterations; then the sums, in the order of the plain loop.
Color visible_sky_fast(const Scene& scene, const Hit& hit, const KnownLightRule& rule, const Frame& frame) {
    const CosineRule& directions = rule.directions;
    const float *const x = directions.x.data(), *y = directions.y.data(), *z = directions.z.data();
    const int *const columns = rule.caps.columns.data(), *rows = rule.caps.rows.data();
    const std::size_t n = directions.size();
    int shadowed = 0;
    of_other_object(scene, hit, [&, point = hit.point](const auto other) {
        for (std::size_t i = 0; i < n; ++i)
            shadowed |= is_shadowed_by(other, point, frame.to_world(Direction{x[i], y[i], z[i]}));
    });
    if (!shadowed) return {1, 1, 1};
    Double4 all{}, visible{};
    for (std::size_t begin = 0; begin < n; begin += batch) {
        const std::size_t end = std::min(begin + batch, n);
        int texel[batch];
        float passes[batch];
        of_other_object(scene, hit, [&, point = hit.point](const auto other) {
            for (std::size_t i = begin; i < end; ++i) {
                const Direction direction = frame.to_world(Direction{x[i], y[i], z[i]});
                const TexelGrid grid(columns[i], rows[i]);
                texel[i - begin] = 3 * grid.texel_index(direction.x, direction.y, direction.z);
                passes[i - begin] = is_shadowed_by(other, point, direction) ? 0 : 1;
            }
        });
        for (std::size_t i = begin; i < end; ++i) {
            const float* t = rule.caps.rgb[i] + texel[i - begin];
            const Double4 light = directions.weights[i] * Double4{t[0], t[1], t[2], t[3]};
            all += light;
            visible += static_cast<double>(passes[i - begin]) * light;
        }
    }
    const Quotient sky{{all[0], all[1], all[2]}, {visible[0], visible[1], visible[2]}};
    return sky.fraction();
}
}  // namespace bmc
