#include "scene/render.h"
#include "test.h"

#include <map>

// The loop that one writes first. In the bytes of a picture another order of the sum would not show.
TEST_CASE("reflected light is (albedo / pi) sum of weight V L, to the last bit") {
    for (const EnvironmentMap& map : {coloured_map(1, 1), coloured_map(7, 5), coloured_map(64, 33)})
        for (const std::size_t n : {1u, 2u, 7u, 64u, 301u}) {
            const QuadratureRule rule = n < 10 ? bayesian_rule(SobolevKnownCosine(), 0.1, some_directions(n))
                                               : cosine_rule(monte_carlo_rule(some_directions(n)));
            INFO("n, map.width: ", n, ", ", map.width);
            std::map<Object, int> partly;
            for_each_hit({9, 9}, [&](int x, int y, const Hit& hit) {
                const Frame frame = Frame(hit.normal).rotated(0.1 * x + 0.01 * y);
                Colour sum;
                std::size_t lit = 0;
                for (std::size_t i = 0; i < n; ++i) {
                    const Vec3 direction = frame.to_world(rule.directions[i]);
                    if (is_shadowed(sphere_scene, hit, direction)) continue;
                    sum += rule.weights[i] * map.radiance(direction);
                    ++lit;
                }
                CHECK(reflected_radiance(sphere_scene, map, hit, rule, frame) == 1 / pi * (hit.albedo * sum));
                partly[hit.object] += lit > 0 && lit < n;
            });
            for (const auto& [object, pixels] : partly) CHECK(pixels >= (n > 10));
        }
}
