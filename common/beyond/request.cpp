#include "beyond/request.h"

namespace bmc::beyond {
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
    options.add("show", show_names, show, ": predicted errors, white at twice the RMSE");
}

void Request::advise(const EnvironmentMap& map) const {
    if (is_plain() && note_missed_light(map, settings.samples)) print_note("note: --known light models this light");
}

Image Request::image(const EnvironmentMap& map) const {
    if (is_plain()) return PictureRequest::image(map);
    const EnvironmentLight light(map, light_known, settings.threads);
    // Where the light is known, the quotient cancels what warned_picture warns of.
    Image image = light_known ? render(map, settings, light_shader(light, settings)) : warned_picture(map, settings);
    if (show == Show::picture) return image;
    const Image errors = predicted_errors(image, render(map, settings, better_shader(light, settings)));
    const double rmse = root_mean_square(errors);
    print_note(formatted("the predicted RMSE is %.2g", rmse));
    return format == Format::pfm ? errors : grey_scale(errors, 2 * rmse);
}
}  // namespace bmc::beyond
