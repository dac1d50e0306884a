#include "picture.h"

#include "sharing/shared_light.h"

namespace bmc {
PictureOptions::PictureOptions(PictureSettings& s)
    : ModelOptions(s),
      method(choice_option("method", "", method_names, s.method)),
      samples(count_option("samples", "N", "directions per pixel (default 40)", s.samples, 1000000)),
      pool(useless_while([&s] { return s.method == Method::pool ? "" : "it belongs to --method pool"; },
                         count_option("pool", "K", "Gaussian processes in the pool (default 20)", s.pool, 1000))),
      share(useless_while(
          [&s] {
              const bool one_rule = s.method == Method::mc || s.method == Method::rotated;
              return one_rule && is_lattice(s.placement) && s.known == Known::light
                         ? ""
                         : "it needs --known light, a lattice as --placement, and --method mc or rotated";
          },
          {"share", "", "neighbouring pixels share what they see of a known light",
           [&s](const std::string&) { s.shared = true; }})) {
    const auto no_process = [&s] { return s.method == Method::mc ? "--method mc makes no Gaussian process" : ""; };
    for (Option& option : process) option = useless_while(no_process, option);
    known = useless_while([&s, no_process] { return s.known == Known::light ? "" : no_process(); },
                          choice_option("known", "known part of the integrand: ", known_names, s.known,
                                        "; the last two for sobolev with smoothness 1.5"));
}

void require_possible(const RenderSettings& settings) {
    const bool one_lattice = settings.method == Method::mc && is_lattice(settings.placement);
    if (!one_lattice && settings.samples > max_process_samples)
        throw UsageError("--samples: " + std::to_string(settings.samples) + " are too many, at most " +
                         std::to_string(max_process_samples) + " are allowed but for --method mc on a lattice");
    require_closed_form(settings);
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
