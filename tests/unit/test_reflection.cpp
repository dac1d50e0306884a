#include "scene/reflection.h"

#include "test.h"

namespace {

// What a pixel does is compared, so that a few processes are enough.
RenderSettings few_pixels(Method method, std::size_t samples, Placement placement = Placement::uniform,
                          Known known = Known::nothing) {
    RenderSettings settings = small(method, samples, 17, placement, known);
    settings.pool = samples > 100 ? 1 : 3;
    settings.height = 13;
    return settings;
}

bool twins_render_alike(const RenderSettings& settings, const EnvironmentMap& light,
                        const Scene& scene = sphere_scene()) {
    return twins_agree([&] { return render(scene, light, settings); });
}

}  // namespace

TEST_CASE("the fast loops give the textbook's bytes for every method, placement and known part") {
    for (const EnvironmentMap& light : {desert, load_environment("bright-desert")})
        for (const Method method : all_methods)
            for (const auto& placement : placement_names)
                for (const Known known : {Known::nothing, Known::cosine})
                    CHECK_MESSAGE(twins_render_alike(few_pixels(method, 11, placement.second, known), light),
                                  placement.first);
}

// Loops take 8 rays at a time, and batches have 256.
TEST_CASE("the fast loops give the textbook's bytes for every number of samples") {
    for (const std::size_t samples : {1u, 2u, 7u, 8u, 9u, 15u, 16u, 17u, 255u, 256u, 257u, 511u, 512u, 513u})
        for (const Method method : {Method::mc, Method::pool})
            CHECK_MESSAGE(twins_render_alike(few_pixels(method, samples), desert), samples);
    CHECK(twins_render_alike(few_pixels(Method::mc, 9000, Placement::fibonacci), desert));
}

TEST_CASE("the fast loops give the textbook's bytes for maps of any size and a sphere in the rectangle's shadow") {
    for (const auto& [width, height] : {std::pair(1, 1), {2, 1}, {1, 2}, {3, 5}, {64, 33}})
        for (const Scene& scene : {sphere_scene(), sphere_below()})
            CHECK(twins_render_alike(few_pixels(Method::rotated, 20), striped_map(width, height), scene));
}

TEST_CASE("after the directions of a rule stand eight zeros, which loops may read") {
    CosineRule rule;
    for (int n = 0; n < 3; ++n) {
        for (const std::vector<float>* component : {&rule.x, &rule.y, &rule.z}) {
            REQUIRE(component->size() == rule.size() + 8);
            for (std::size_t i = rule.size(); i < component->size(); ++i) CHECK((*component)[i] == 0);
        }
        rule.add({0.6, 0.8, 1}, 1);
    }
}
