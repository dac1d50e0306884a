#include "beyond/request.h"

namespace bmc::beyond {
static void print_prediction(std::size_t samples, double rmse) {
    print_note(formatted("%zu sample%s for a predicted RMSE of %.2g", samples, samples == 1 ? "" : "s", rmse));
}

// The root mean square over each pixel's colours, from black at 0 to white at `white`.
static Image grey_scale(Image errors, double white) {
    for (Colour& pixel : errors.pixels) {
        const double level = white > 0 ? std::sqrt(dot(pixel, pixel) / 3) / white : 0;
        pixel = {level, level, level};
    }
    return errors;
}

void Request::add_options(Options& options) {
    PictureRequest::add_options(options);
    options.replace(choice("known", {"nothing", "cosine", "light"}, 0, known_remark, [this](std::size_t chosen) {
        settings.known_part = chosen > 0 ? KnownPart::cosine : KnownPart::nothing;
        light_known = chosen == 2;
    }));
    options.make_idle({"known"}, "with --method mc", [this] { return settings.method == Method::mc && !light_known; });
    options.add("rmse", "X", "take as few samples as reach this predicted RMSE; 0: --samples", rmse, 0, 1e9);
    options.add("show", show_names, show, ": predicted errors, white at twice the RMSE");
    options.make_idle({"samples"}, "with --rmse", [this] { return rmse > 0; });
}

void Request::advise(const EnvironmentMap& map) const {
    if (is_plain() && note_missed_light(map, settings.samples)) print_note("note: --known light models this light");
}

Image Request::image(const EnvironmentMap& map) const {
    if (is_plain()) return PictureRequest::image(map);
    RenderSettings chosen = settings;
    const EnvironmentLight light(map, light_known, settings.threads);
    if (rmse > 0) {
        const Prediction found = samples_for(rmse, max_process_samples, light, chosen);
        if (found.samples > static_cast<double>(max_process_samples))
            throw std::runtime_error("--rmse: about " + two_digits(found.samples) + " samples would be needed" +
                                     formatted(", and %zu are the most allowed", max_process_samples) +
                                     (light_known ? "" : "; take --known light, with the default covariance"));
        chosen.samples = static_cast<std::size_t>(found.samples);
        print_prediction(chosen.samples, found.rmse);
    }
    // A quotient of sums, where the light is known, has no errors that weights could be warned of.
    Image image = light_known ? render(map, chosen, light_shader(light, chosen)) : warned_picture(map, chosen);
    if (show == Show::picture) return image;
    const Image errors = predicted_errors(image, render(map, chosen, better_shader(light, chosen)));
    const double predicted = root_mean_square(errors);
    if (rmse == 0) print_prediction(chosen.samples, predicted);
    return format == Format::pfm ? errors : grey_scale(errors, 2 * predicted);
}
}  // namespace bmc::beyond
