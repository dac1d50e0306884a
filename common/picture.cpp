#include "picture.h"

#include "sharing/shared_light.h"

namespace bmc {
PictureOptions::PictureOptions(PictureSettings& s)
    : RenderOptions(s),
      share(useless_while(
          [&s] {
              const bool one_rule = s.method == Method::mc || s.method == Method::rotated;
              return one_rule && is_lattice(s.placement) && s.known == Known::light
                         ? ""
                         : "it needs --known light, a lattice as --placement, and --method mc or rotated";
          },
          {"share", "", "neighbouring pixels share what they see of a known light",
           [&s](const std::string&) { s.shared = true; }})) {
    known =
        useless_while([&s, unless_light = known.why_useless] { return s.known == Known::light ? "" : unless_light(); },
                      choice_option("known", "known part of the integrand: ", known_names, s.known,
                                    "; the last two for sobolev with smoothness 1.5"));
}

EnvironmentLight prefilter(const EnvironmentMap& environment, unsigned threads) {
    return {environment, std::make_shared<const PrefilteredEnvironment>(environment, threads)};
}

Shade shade_of(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings) {
    if (settings.shared) return reflected_shared_light(scene, *light.prefiltered, settings);
    if (settings.known == Known::light) return reflected_known_light(scene, *light.prefiltered, settings);
    return reflected_environment(scene, light.environment, settings);
}

Image picture(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings) {
    return render(scene, light.environment, settings, shade_of(scene, light, settings));
}
}  // namespace bmc
