#include "predicted_picture.h"

#include "known_light/known_light_error.h"
#include "scene/object_pixels.h"

#include <cstdio>

namespace bmc {
namespace {

ErrorOf error_of(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings,
                 const Progress& progress) {
    if (settings.light_known) return error_of_known_light(scene, *light.prefiltered, settings, progress);
    return error_of_picture(scene, light.environment, settings, progress);
}

// sun: the share of the light that the prediction leaves out.
void tell_prediction(const PictureSettings& settings, double rmse, double sun) {
    std::string remark;
    if (sun > 0)
        remark = formatted("; it leaves out the sun, %.3g %% of the light: take --known light", 100 * sun);
    else if (settings.method == Method::single)
        remark = "; all pixels share one rule, and this seed may be far off";
    std::fprintf(stderr, "renderer: %zu sample%s for a predicted RMSE of %.2g%s\n", settings.samples,
                 settings.samples == 1 ? "" : "s", rmse, remark.c_str());
}

}  // namespace

PredictionOptions::PredictionOptions(Prediction& p)
    : rmse(real_option("rmse", "X", "take the fewest samples whose predicted RMSE is at most X", p.rmse, {1e-9, 1e9})),
      show(choice_option("show", "", show_names, p.show,
                         ": the predicted standard error of every pixel; as PPM black is 0, and white twice the "
                         "picture's RMSE")) {}

void require_predictable(const Prediction& prediction, const PictureSettings& settings) {
    if (prediction.is_asked() && settings.method == Method::mc && is_lattice(settings.placement))
        throw UsageError(
            "--method mc predicts no error on a lattice, whose samples do not differ as independent ones do; take "
            "--placement uniform or cosine, or another method");
}

Image predicted_picture(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings,
                        const Progress& progress) {
    const double share = PixelRules::share_of_work(settings);
    const ErrorOf error = error_of(scene, light, settings, part_of(progress, 0, share));
    return predicted_errors(scene, settings, error, part_of(progress, share, 1));
}

ChosenSamples samples_for(double target, std::size_t most, const Scene& scene, const EnvironmentLight& light,
                          const PictureSettings& settings) {
    const bool has_sun = settings.light_known && !light.prefiltered->sun().empty();
    const auto error = [&, tried = settings](const RenderSettings& rules) mutable {
        static_cast<RenderSettings&>(tried) = rules;
        return error_of(scene, light, tried, nullptr);
    };
    return samples_for(target, has_sun ? 4 : 2, most, scene, settings, error);
}

Image asked_picture(const EnvironmentMap& environment, PictureSettings settings, const Prediction& prediction,
                    Format format, const Progress& progress) {
    const Scene scene = sphere_scene();
    const EnvironmentLight light =
        settings.light_known ? prefilter(environment, settings.threads) : EnvironmentLight{environment};
    const double unknown_sun = prediction.is_asked() && !settings.light_known ? Sun(environment).share() : 0;
    if (prediction.rmse > 0) {
        if (unknown_sun > 0)
            throw UsageError(
                formatted("--rmse: the sun sends %.3g %% of the light, and samples that miss it do not "
                          "know of it; take --known light",
                          100 * unknown_sun));
        const ChosenSamples chosen = samples_for(prediction.rmse, max_process_samples, scene, light, settings);
        settings.samples = chosen.samples;
        tell_prediction(settings, chosen.rmse, 0);
    }
    if (prediction.show == Show::picture) return picture(scene, light, settings, progress);
    try {
        const Image errors = predicted_picture(scene, light, settings, progress);
        const double rmse = root_mean_square(errors, object_pixels(scene, {settings.width, settings.height}));
        if (prediction.rmse == 0) tell_prediction(settings, rmse, unknown_sun);
        return format == Format::ppm ? grey_scale(errors, 2 * rmse) : errors;
    } catch (const std::invalid_argument& error) {
        throw UsageError(std::string("--samples: ") + error.what());
    }
}
}  // namespace bmc
