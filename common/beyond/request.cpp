#include "beyond/request.h"

#include "scene/advice.h"

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
    options.named("known") =
        choice("known", {"nothing", "cosine", "light"}, 0, known_remark, [this](std::size_t chosen) {
            settings.known_part = chosen > 0 ? KnownPart::cosine : KnownPart::nothing;
            by_visibility = chosen == 2;
        });
    options.make_idle({"known"}, "with --method mc",
                      [this] { return settings.method == Method::mc && !by_visibility; });
    options.add("rmse", "X", "take as few samples as reach this predicted RMSE; 0: --samples", rmse, 0, 1e9);
    options.add("show", show_names, show, ": predicted errors, white at twice the RMSE");
    options.make_idle({"samples"}, "with --rmse", [this] { return rmse > 0; });
}

Image Request::image(const EnvironmentMap& map) const {
    RenderSettings chosen = settings;
    const EnvironmentLight light(map, by_visibility, settings.threads);
    if (rmse > 0) {
        const Prediction found = samples_for(rmse, max_process_samples, light, chosen);
        if (found.samples > static_cast<double>(max_process_samples))
            throw std::runtime_error("--rmse: about " + two_digits(found.samples) + " samples would be needed" +
                                     formatted(", and %zu are the most allowed", max_process_samples) +
                                     (by_visibility ? "" : "; take --known light, with the default covariance"));
        chosen.samples = static_cast<std::size_t>(found.samples);
        print_prediction(chosen.samples, found.rmse);
    }
    if (!by_visibility && rmse == 0 && show == Show::picture && note_missed_light(map, chosen.samples))
        print_note("note: --known light models this light");
    // A quotient of sums, where the light is known, has no errors that weights could be warned of.
    Image image = render(map, chosen, by_visibility ? shader_of(light, chosen) : warned_shader(map, chosen));
    if (show == Show::picture) return image;
    const Image errors = predicted_errors(image, render(map, chosen, better_shader(light, chosen)));
    const double predicted = root_mean_square(errors);
    if (rmse == 0) print_prediction(chosen.samples, predicted);
    return format == Format::pfm ? errors : grey_scale(errors, 2 * predicted);
}
}  // namespace bmc::beyond
