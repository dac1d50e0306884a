#include "scene/render.h"

namespace bmc {
Image render(const Scene& scene, const EnvironmentMap& environment, const RenderSettings& settings,
             const Progress& progress) {
    const double share = PixelRules::share_of_work(settings);
    const PixelRules rules(settings, part_of(progress, 0, share));
    const auto shade = [&](const Hit& hit, Random& random) {
        const PlacedRule placed = rules.rule_for(hit.normal, random);
        return reflected_light(scene, environment, hit, placed.rule->directions, placed.frame);
    };
    return render(scene, environment, settings, shade, part_of(progress, share, 1));
}

Image render(const Scene& scene, const EnvironmentMap& background, const RenderSettings& settings, const Shade& shade,
             const Progress& progress) {
    const Camera camera{settings.width, settings.height};
    Image image(settings.width, settings.height);
    const auto row = [&](int y) {
        for (int x = 0; x < settings.width; ++x) {
            const Ray ray = camera.ray(x, y);
            const std::optional<Hit> hit = intersect(scene, ray);
            Random random = pixel_stream(settings, x, y);
            image.set(x, y, hit ? shade(*hit, random) : background.interpolated_radiance(ray.direction));
        }
    };
    for_each_row(settings.height, settings.threads, row, progress);
    return image;
}
}  // namespace bmc
