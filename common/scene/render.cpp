#include "scene/render.h"

#include "numerics/parallel.h"

namespace bmc {
Shader environment_shader(const Scene& scene, const EnvironmentMap& environment, const PixelRules& rules) {
    return [&scene, &environment, rules](const Hit& hit, int x, int y) {
        Random random = pixel_stream(rules.settings(), x, y);
        const OrientedRule oriented = rules.rule_for(hit.normal, random);
        return reflected_radiance(scene, environment, hit, *oriented.rule, oriented.frame);
    };
}

Image render(const Scene& scene, const EnvironmentMap& background, const RenderSettings& settings,
             const Shader& shade) {
    Image image(settings.width, settings.height);
    for_each_row(settings.height, settings.threads, [&](int y) {
        for (int x = 0; x < settings.width; ++x) {
            const Ray ray = Camera{settings.width, settings.height}.ray(x, y);
            const std::optional<Hit> hit = intersect(scene, ray);
            image(x, y) = hit ? shade(*hit, x, y) : background.bilinear_radiance(ray.direction);
        }
    });
    return image;
}

Image picture(const EnvironmentMap& light, const RenderSettings& settings) {
    const Scene scene = sphere_scene();
    return render(scene, light, settings, environment_shader(scene, light, PixelRules(settings)));
}
}  // namespace bmc
