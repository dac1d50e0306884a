#include "picture.h"

#include "known_light/known_light.h"

namespace bmc {
void PictureSettings::set_known(Known part) {
    light_known = part == Known::light;
    known = part == Known::nothing ? KnownPart::nothing : KnownPart::cosine;
}

Known PictureSettings::known_part() const {
    if (light_known) return Known::light;
    return known == KnownPart::cosine ? Known::cosine : Known::nothing;
}

PictureOptions::PictureOptions(PictureSettings& s) : RenderOptions(s) {
    Option& known = of_process("known");
    known = {"known", "NAME",
             "known part of the integrand: " + choices(known_names, s.known_part()) +
                 "; the last two for sobolev with smoothness 1.5",
             [&s](const std::string& text) { s.set_known(parse_choice(text, known_names)); },
             [&s, unless_known = known.why_useless] { return s.light_known ? "" : unless_known(); }};
}

EnvironmentLight prefilter(const EnvironmentMap& environment, unsigned threads) {
    return {environment, std::make_shared<const PrefilteredEnvironment>(environment, threads)};
}

Image picture(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings,
              const Progress& progress) {
    if (!settings.light_known) return render(scene, light.environment, settings, progress);
    const double share = PixelRules::share_of_work(settings);
    const Shade shade = reflected_known_light(scene, *light.prefiltered, settings, part_of(progress, 0, share));
    return render(scene, light.environment, settings, shade, part_of(progress, share, 1));
}
}  // namespace bmc
