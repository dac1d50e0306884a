#include "scene/reflection.h"
#include "test.h"

#include <map>

TEST_CASE("a rule for cos(theta) has it in its weights, once") {
    const QuadratureRule rule{{{0.6, 0.8, 0}, {0, 1, 0}, {0, 0, 1}}, {3, -2, 5}, Known::nothing};
    const QuadratureRule folded = cosine_rule(rule);
    CHECK(folded.weights == std::vector<double>{3 * 0.8, -2, 0});
    CHECK(folded.known == Known::cosine);
    CHECK(cosine_rule(folded).weights == folded.weights);
    CHECK(rule.directions == folded.directions);
}

// The loop that one writes first.
TEST_CASE("reflected light is (albedo / pi) sum of weight V L, to the last bit") {
    const Scene scene = test_scene();
    for (const EnvironmentMap& map : {coloured_map(1, 1), coloured_map(7, 5), coloured_map(64, 33)})
        for (const std::size_t n : {1u, 2u, 7u, 64u, 301u}) {
            const QuadratureRule rule = n < 10 ? bayesian_rule(SobolevKnownCosine(), 0.1, some_directions(n))
                                               : cosine_rule(monte_carlo_rule({some_directions(n)}));
            INFO("n, map.width: ", n, ", ", map.width);
            std::map<Object, int> partly;
            for_each_hit(scene, {9, 9}, [&](int x, int y, const Hit& hit) {
                const Frame frame = Frame(hit.normal).rotated(0.1 * x + 0.01 * y);
                Color sum;
                std::size_t lit = 0;
                for (std::size_t i = 0; i < n; ++i) {
                    const Vec3 direction = frame.to_world(rule.directions[i]);
                    if (is_shadowed(scene, hit, direction)) continue;
                    sum += rule.weights[i] * map.radiance(direction);
                    ++lit;
                }
                CHECK(reflected_radiance(scene, map, hit, rule, frame) == 1 / pi * (hit.albedo * sum));
                partly[hit.object] += lit > 0 && lit < n;
            });
            for (const auto& [object, pixels] : partly) CHECK(pixels >= (n > 10));
        }
}
