#include "scene/render.h"

#include "numerics/cholesky.h"
#include "scene/desert.h"

#include <doctest/doctest.h>

#include <string>

namespace {

const EnvironmentMap desert = built_in_environment(), sun = bright_desert();
const Light lights[] = {desert, sun};

// By the textbook's loops and by the fast ones.
bool agree(RenderSettings settings, const Light& light, const Scene& scene = sphere_scene()) {
    settings.plain = false;
    const std::string fast = to_pfm(render(scene, light, settings));
    settings.plain = true;
    return to_pfm(render(scene, light, settings)) == fast;
}

// What a pixel does is compared, so that a few processes are enough.
RenderSettings small(Method method, std::size_t samples) {
    RenderSettings settings;
    settings.method = method;
    settings.samples = samples;
    settings.pool = 3;
    settings.width = 17;
    settings.height = 13;
    return settings;
}

const Method all_methods[] = {Method::mc, Method::direct, Method::single, Method::rotated, Method::pool};

}  // namespace

TEST_CASE("the fast loops give the textbook's bytes for every method, placement and known part") {
    for (const Light& light : lights)
        for (const Method method : all_methods)
            for (const auto& placement : placement_names)
                for (const KnownPart known : {KnownPart::nothing, KnownPart::cosine, KnownPart::light}) {
                    RenderSettings settings = small(method, 11);
                    settings.placement = placement.second;
                    settings.known = known;
                    CAPTURE(placement.first);
                    CHECK(agree(settings, light));
                }
}

// Batches, vectors and blocks end at 8, 16, 64 pixels, 256 and 1024 rays.
TEST_CASE("the fast loops give the textbook's bytes for every number of samples") {
    for (const std::size_t samples : {1u, 2u, 7u, 8u, 9u, 15u, 16u, 17u, 255u, 256u, 257u, 511u, 512u, 513u})
        for (const Method method : {Method::mc, Method::pool})
            for (const KnownPart known : {KnownPart::nothing, KnownPart::light}) {
                RenderSettings settings = small(method, samples);
                settings.pool = samples > 100 ? 1 : 3;
                settings.known = known;
                CAPTURE(samples);
                CHECK(agree(settings, lights[0]));
            }
    for (const std::size_t samples : {4096u, 4097u, 9000u})
        for (const Placement placement : {Placement::uniform, Placement::fibonacci})
            for (const KnownPart known : {KnownPart::nothing, KnownPart::light}) {
                RenderSettings settings = small(Method::mc, samples);
                settings.placement = placement;
                settings.width = settings.height = 9;
                settings.known = known;
                CAPTURE(samples);
                CHECK(agree(settings, lights[1]));
            }
}

TEST_CASE("a picture that is refused leaves nothing in the next one") {
    RenderSettings refused = small(Method::direct, 80);
    refused.covariance = CovarianceFamily::squared_exponential;
    refused.noise = 0;
    refused.threads = 1;
    CHECK_THROWS_AS(render(sphere_scene(), lights[0], refused), NotPositiveDefinite);
    RenderSettings settings = small(Method::pool, 40);
    settings.threads = 1;
    CHECK(agree(settings, lights[0]));
}

TEST_CASE("the fast loops give the textbook's bytes for pictures of any size, and on several threads") {
    for (const int width : {1, 2, 63, 64, 65, 200})
        for (const int height : {1, 3, 50})
            for (const KnownPart known : {KnownPart::nothing, KnownPart::light}) {
                RenderSettings settings = small(Method::pool, 5);
                settings.width = width;
                settings.height = height;
                settings.threads = 3;
                settings.known = known;
                CHECK(agree(settings, lights[1]));
            }
}

TEST_CASE(
    "the fast loops give the textbook's bytes for maps of any size and for the sphere in the rectangle's shadow") {
    Scene under = sphere_scene();
    under.sphere.radius = 0.8;
    under.rectangle.y = 1.2;
    for (const auto& [width, height] : {std::pair(1, 1), {2, 1}, {1, 2}, {3, 5}, {64, 33}}) {
        std::vector<float> rgb;
        for (int i = 0; i < 3 * width * height; ++i) rgb.push_back(static_cast<float>(i % 7));
        const EnvironmentMap map(width, height, rgb);
        for (const KnownPart known : {KnownPart::nothing, KnownPart::light})
            for (const Scene& scene : {sphere_scene(), under}) {
                RenderSettings settings = small(Method::rotated, 20);
                settings.known = known;
                CHECK(agree(settings, map, scene));
            }
    }
}
