#include "known_light/picture_options.h"

#include <cstdio>

namespace bmc {
namespace {

UsageError too_few() {
    return UsageError("--samples: one direction says nothing of the error of its mean; take more samples");
}

void tell_prediction(const PictureSettings& settings, double rmse) {
    std::fprintf(stderr, "renderer: %zu sample%s for a predicted RMSE of %.2g%s\n", settings.samples,
                 settings.samples == 1 ? "" : "s", rmse,
                 settings.method == Method::single ? "; all pixels share one rule, and this seed may be far off" : "");
}

}  // namespace

PictureOptions::PictureOptions(PictureSettings& s)
    : RenderOptions(s),
      rmse(real_option("rmse", "X", "of the picture, predicted: takes the fewest samples that have at most this",
                       s.rmse, {1e-9, 1e9})),
      show(choice_option("show", "", show_names, s.show,
                         ": the predicted standard error of every pixel; as PPM black is 0, and white twice the "
                         "picture's RMSE")) {
    samples = useless_while([&s] { return s.rmse > 0 ? "--rmse chooses their number" : ""; }, samples);
    Option& known = of_process("known");
    known = {"known", "NAME",
             "part of the integrand: " + choices(known_names, s.known_part()) +
                 "; the last two for sobolev with smoothness 1.5",
             [&s](const std::string& text) { s.set_known(parse_choice(text, known_names)); },
             [&s, unless_known = known.why_useless] { return s.light_known ? "" : unless_known(); }};
}

void require_predictable(const PictureSettings& settings) {
    if (settings.rmse == 0 && settings.show == Show::picture) return;
    const bool mc = settings.method == Method::mc;
    if (mc && is_lattice(settings.placement))
        throw UsageError(
            "--method mc predicts no error on a lattice, whose samples do not differ as independent ones do; take "
            "--placement uniform or cosine, or another method");
    if (mc && settings.samples == 1) throw too_few();
}

Image asked_picture(const EnvironmentMap& environment, PictureSettings settings, Format format,
                    const Progress& progress) {
    std::optional<PrefilteredEnvironment> prefiltered;
    if (settings.light_known) prefiltered.emplace(environment, settings.threads);
    if (prefiltered && settings.show == Show::error && sky_settings(settings, *prefiltered).samples == 1)
        throw too_few();
    const EnvironmentLight light{environment, prefiltered ? &*prefiltered : nullptr};
    const Scene scene = sphere_scene();
    if (settings.rmse > 0) {
        const ChosenSamples chosen = samples_for(settings.rmse, max_process_samples, scene, light, settings);
        settings.samples = chosen.samples;
        tell_prediction(settings, chosen.rmse);
    }
    Image image = picture(scene, light, settings, progress);
    if (settings.show == Show::picture) return image;
    const double rmse = root_mean_square(image, object_pixels(scene, {settings.width, settings.height}));
    if (settings.rmse == 0) tell_prediction(settings, rmse);
    return format == Format::ppm ? grey_scale(image, 2 * rmse) : image;
}
}  // namespace bmc
