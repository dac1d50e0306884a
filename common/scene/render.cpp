#include "scene/render.h"

namespace bmc {
Shader environment_shader(const EnvironmentMap& environment, const PixelRules& rules) {
    return [&environment, rules](const Hit& hit, int x, int y) {
        Random random = pixel_stream(rules.settings, x, y);
        const OrientedRule oriented = rules.rule_for(hit.normal, random);
        return reflected_radiance(sphere_scene, environment, hit, *oriented.rule, oriented.frame);
    };
}

// How long a row takes, in any unit. Sky takes almost no time, so this counts objects in some of the row's pixels.
static double work(const Camera& camera, int y) {
    const int step = std::max(1, camera.width / 8);
    double objects = 0.1;
    for (int x = step / 2; x < camera.width; x += step)
        objects += intersect(sphere_scene, camera.ray(x, y)).has_value();
    return objects;
}

Image render(const EnvironmentMap& background, const RenderSettings& settings, const Shader& shade) {
    Image image(settings.width, settings.height);
    const Camera camera{settings.width, settings.height};
    double all_work = 0;
    for (int y = 0; y < settings.height; ++y) all_work += work(camera, y);
    Progress progress(all_work);
    for_each_row(settings.height, settings.threads, [&](int y) {
        for (int x = 0; x < settings.width; ++x) {
            const Ray ray = camera.ray(x, y);
            const std::optional<Hit> hit = intersect(sphere_scene, ray);
            image(x, y) = hit ? shade(*hit, x, y) : background.bilinear_radiance(ray.direction);
        }
        progress.done(work(camera, y));
    });
    return image;
}
}  // namespace bmc
