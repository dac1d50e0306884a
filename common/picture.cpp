#include "picture.h"

#include "known_light/known_light_error.h"

namespace bmc {
void PictureSettings::set_known(Known part) {
    light_known = part == Known::light;
    known = part == Known::nothing ? KnownPart::nothing : KnownPart::cosine;
}

Known PictureSettings::known_part() const {
    if (light_known) return Known::light;
    return known == KnownPart::cosine ? Known::cosine : Known::nothing;
}

EnvironmentLight prefilter(const EnvironmentMap& environment, unsigned threads) {
    return {environment, std::make_shared<const PrefilteredEnvironment>(environment, threads)};
}

double unknown_sun(const EnvironmentMap& environment, const PictureSettings& settings) {
    return settings.light_known ? 0 : Sun(environment).share();
}

Image picture(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings,
              const Progress& progress) {
    const auto& [environment, prefiltered] = light;
    if (settings.show == Show::picture && !settings.light_known) return render(scene, environment, settings, progress);
    const double share = PixelRules::share_of_work(settings);
    const Progress rules = part_of(progress, 0, share), rows = part_of(progress, share, 1);
    if (settings.show == Show::picture)
        return render(scene, environment, settings, reflected_known_light(scene, *prefiltered, settings, rules), rows);
    return predicted_errors(scene, settings,
                            settings.light_known ? error_of_known_light(scene, *prefiltered, settings, rules)
                                                 : error_of_picture(scene, environment, settings, rules),
                            rows);
}

ChosenSamples samples_for(double target, std::size_t most, const Scene& scene, const EnvironmentLight& light,
                          const PictureSettings& settings) {
    const bool has_sun = settings.light_known && !light.prefiltered->sun().empty();
    return samples_for(target, has_sun ? 4 : 2, most, scene, settings, [&](const RenderSettings& tried) {
        return settings.light_known ? error_of_known_light(scene, *light.prefiltered, tried)
                                    : error_of_picture(scene, light.environment, tried);
    });
}
}  // namespace bmc
