#include "scene/render.h"

namespace bmc {
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
    Progress progress(static_cast<std::size_t>(settings.height));
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
