#include "beyond/request.h"

#include "numerics/progress.h"

namespace bmc::beyond {
// sun: the fraction of the light that both pictures may miss.
static void print_prediction(const PictureSettings& settings, double rmse, double sun) {
    std::string remark;
    if (sun > 0)
        remark = formatted("; it may miss the sun, %.3g %% of the light: take --known light", 100 * sun);
    else if (settings.method == Method::single)
        remark = "; all pixels share one rule, and this seed may be far off";
    print_note(formatted("%zu sample%s for a predicted RMSE of %.2g%s", settings.samples,
                         settings.samples == 1 ? "" : "s", rmse, remark.c_str()));
}

// The root mean square of each pixel's colours, from black at 0 to white at `white`.
static Image grey_scale(Image errors, double white) {
    for (Color& pixel : errors.pixels) {
        const double level = white > 0 ? std::sqrt(dot(pixel, pixel) / 3) / white : 0;
        pixel = {level, level, level};
    }
    return errors;
}

Options Request::options() {
    Options all = options_with(enum_option("known", known_factor_names, known, known_remark));
    all.push_back(real_option("rmse", "in place of --samples: the fewest with this predicted RMSE", rmse, 1e-9, 1e9));
    all.push_back(enum_option("show", show_names, show, ": predicted errors, white at twice RMSE"));
    return all;
}

std::vector<IdleOption> Request::idle() const {
    std::vector<IdleOption> idle = PictureRequest::idle();
    if (known == KnownFactor::light)  // of all methods
        idle.erase(std::remove_if(idle.begin(), idle.end(), [](const auto& each) { return each.name == "known"; }),
                   idle.end());
    if (rmse > 0) idle.push_back({"samples", "--rmse"});
    return idle;
}

Image Request::image(const EnvironmentMap& map) const {
    const bool light_known = known == KnownFactor::light;
    PictureSettings chosen{settings, light_known};
    chosen.known = known == KnownFactor::nothing ? Known::nothing : Known::cosine;
    const EnvironmentLight light(map, light_known, settings.threads);
    const double sun = light_known || (rmse == 0 && show == Show::picture) ? 0 : Sun(map).share();
    if (rmse > 0) {
        if (sun > 0)
            throw std::invalid_argument(
                formatted("--rmse: samples may miss the sun, which sends %.3g %% of the light; take --known "
                          "light",
                          100 * sun));
        const ChosenSamples found = samples_for(rmse, max_process_samples, light, chosen);
        chosen.samples = found.samples;
        print_prediction(chosen, found.rmse, 0);
    }
    const Scene scene = sphere_scene();
    const PixelRules rules = rules_of(light, chosen);
    warn_of_weights(rules);
    Progress progress(show == Show::picture ? 1 : 2);
    Image image = render(scene, map, chosen, shader_of(scene, light, chosen, rules));
    if (show == Show::picture) return image;
    progress.done();
    Image errors = standard_errors(image, picture(light, with_next_seed(chosen)));
    const double predicted = root_mean_square(errors);
    if (rmse == 0) print_prediction(chosen, predicted, sun);
    if (format == Format::ppm) return grey_scale(std::move(errors), 2 * predicted);
    return errors;
}
}  // namespace bmc::beyond
