#include "beyond/known_light/picture.h"

namespace bmc::beyond {
EnvironmentLight::EnvironmentLight(const EnvironmentMap& map, bool known, unsigned threads) : environment(map) {
    if (known) prefiltered = std::make_shared<const PrefilteredEnvironment>(map, threads);
}

PixelRules rules_of(const EnvironmentLight& light, const PictureSettings& settings) {
    if (!settings.light_known) return PixelRules(settings);
    return PixelRules(sky_settings(settings, *light.prefiltered));
}

Shade shade_of(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings,
               const PixelRules& rules) {
    if (!settings.light_known) return reflected_environment(scene, light.environment, rules);
    return reflected_known_light(scene, *light.prefiltered, rules, sun_samples(*light.prefiltered, settings.samples));
}

Image picture(const EnvironmentLight& light, const PictureSettings& settings) {
    const Scene scene = sphere_scene();
    return render(scene, light.environment, settings, shade_of(scene, light, settings, rules_of(light, settings)));
}
}  // namespace bmc::beyond
