#include "picture.h"

#include "known_light/known_light.h"

namespace bmc {
PictureOptions::PictureOptions(PictureSettings& s) : RenderOptions(s) {
    Option& known = of_process("known");
    const auto unless_light = [&s, why_useless = known.why_useless] {
        return s.known == Known::light ? "" : why_useless();
    };
    known = choice_option("known", "known part of the integrand: ", known_names, s.known,
                          "; the last two for sobolev with smoothness 1.5");
    known.why_useless = unless_light;
}

EnvironmentLight prefilter(const EnvironmentMap& environment, unsigned threads) {
    return {environment, std::make_shared<const PrefilteredEnvironment>(environment, threads)};
}

Shade shade_of(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings) {
    if (settings.known == Known::light) return reflected_known_light(scene, *light.prefiltered, settings);
    return reflected_environment(scene, light.environment, settings);
}

Image picture(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings) {
    return render(scene, light.environment, settings, shade_of(scene, light, settings));
}
}  // namespace bmc
