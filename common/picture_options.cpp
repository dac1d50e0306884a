#include "picture_options.h"

#include <cstdio>

namespace bmc {
namespace {

void tell_prediction(const PictureSettings& settings, double rmse, double sun) {
    std::string remark;
    if (sun > 0)
        remark = formatted("; it leaves out the sun, %.3g %% of the light: take --known light", 100 * sun);
    else if (settings.method == Method::single)
        remark = "; all pixels share one rule, and this seed may be far off";
    std::fprintf(stderr, "renderer: %zu sample%s for a predicted RMSE of %.2g%s\n", settings.samples,
                 settings.samples == 1 ? "" : "s", rmse, remark.c_str());
}

Image possible_picture(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings,
                       const Progress& progress) {
    try {
        return picture(scene, light, settings, progress);
    } catch (const std::invalid_argument& error) {
        throw UsageError(std::string("--samples: ") + error.what());
    }
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
    if (!settings.asks_for_error()) return;
    if (settings.method == Method::mc && is_lattice(settings.placement))
        throw UsageError(
            "--method mc predicts no error on a lattice, whose samples do not differ as independent ones do; take "
            "--placement uniform or cosine, or another method");
}

Image asked_picture(const EnvironmentMap& environment, PictureSettings settings, Format format,
                    const Progress& progress) {
    const double sun = settings.asks_for_error() ? unknown_sun(environment, settings) : 0;
    if (settings.rmse > 0 && sun > 0)
        throw UsageError(
            formatted("--rmse: the sun sends %.3g %% of the light, and samples that miss it do not know of it; take "
                      "--known light",
                      100 * sun));
    const EnvironmentLight light =
        settings.light_known ? prefilter(environment, settings.threads) : EnvironmentLight{environment};
    const Scene scene = sphere_scene();
    if (settings.rmse > 0) {
        const ChosenSamples chosen = samples_for(settings.rmse, max_process_samples, scene, light, settings);
        settings.samples = chosen.samples;
        tell_prediction(settings, chosen.rmse, 0);
    }
    Image image = possible_picture(scene, light, settings, progress);
    if (settings.show == Show::picture) return image;
    const double rmse = root_mean_square(image, object_pixels(scene, {settings.width, settings.height}));
    if (settings.rmse == 0) tell_prediction(settings, rmse, sun);
    return format == Format::ppm ? grey_scale(image, 2 * rmse) : image;
}
}  // namespace bmc
