#include "beyond/known_light/picture.h"

namespace bmc::beyond {
EnvironmentLight::EnvironmentLight(const EnvironmentMap& map, bool known, unsigned threads) : environment(map) {
    if (known) prefiltered = std::make_shared<const PrefilteredEnvironment>(map, threads);
}

PixelRules rules_of(const EnvironmentLight& light, const PictureSettings& settings) {
    if (!settings.light_known) return PixelRules(settings);
    return PixelRules(sky_settings(settings, *light.prefiltered));
}

Shader shader_of(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings,
                 const PixelRules& rules) {
    if (!settings.light_known) return environment_shader(scene, light.environment, rules);
    return known_light_shader(scene, *light.prefiltered, rules, sun_samples(*light.prefiltered, settings.samples));
}

Image picture(const EnvironmentLight& light, const PictureSettings& settings) {
    const Scene scene = sphere_scene();
    return render(scene, light.environment, settings, shader_of(scene, light, settings, rules_of(light, settings)));
}
}  // namespace bmc::beyond
