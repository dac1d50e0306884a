#include "scene/render.h"

namespace bmc {
Shade reflected_environment(const Scene& scene, const EnvironmentMap& environment, const RenderSettings& settings) {
    const auto rules = std::make_shared<const PixelRules>(settings);
    return [&scene, &environment, settings, rules](const Hit& hit, int x, int y) {
        Random random = pixel_stream(settings, x, y);
        const auto [rule, frame] = rules->rule_for(hit.normal, random);
        return reflected_light(scene, environment, hit, *rule, frame);
    };
}

Image render(const Scene& scene, const EnvironmentMap& background, const RenderSettings& settings, const Shade& shade) {
    const Camera camera{settings.width, settings.height};
    Image image(settings.width, settings.height);
    const auto row = [&](int y) {
        for (int x = 0; x < settings.width; ++x) {
            const Ray ray = camera.ray(x, y);
            const std::optional<Hit> hit = intersect(scene, ray);
            image.set(x, y, hit ? shade(*hit, x, y) : background.interpolated_radiance(ray.direction));
        }
    };
    for_each_row(settings.height, settings.threads, row, settings.progress);
    return image;
}

Image render(const Scene& scene, const EnvironmentMap& environment, const RenderSettings& settings) {
    return render(scene, environment, settings, reflected_environment(scene, environment, settings));
}
}  // namespace bmc
