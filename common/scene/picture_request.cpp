#include "scene/picture_request.h"

#include "light/texels_on_sphere.h"
#include "base/statistics.h"

namespace bmc {
static void set_size(RenderSettings& settings, const std::string& text) {
    const std::size_t cross = text.find('x');
    try {
        settings.width = parse<int>(text.substr(0, cross), 1, 8192);
        settings.height = cross == std::string::npos ? settings.width : parse<int>(text.substr(cross + 1), 1, 8192);
    } catch (const std::invalid_argument&) {
        throw std::invalid_argument("'" + text + "' is not WxH or W, of whole numbers from 1 to 8192");
    }
}

// Prints a warning if more than a tenth of the objects' pixels is brighter than white.
static void warn_of_exposure(const Image& image, double exposure) {
    const auto brightest_channel = [](Color pixel) { return std::max({pixel.x, pixel.y, pixel.z}); };
    const auto above_white = [&](Color pixel) { return brightest_channel(pixel) > 1; };
    if (std::none_of(image.pixels.begin(), image.pixels.end(), above_white)) return;
    std::vector<double> brightness;
    for_each_hit(sphere_scene, {image.width, image.height},
                 [&](int x, int y, const Hit&) { brightness.push_back(brightest_channel(image(x, y))); });
    std::sort(brightness.begin(), brightness.end());
    const std::size_t n = brightness.size();
    if (n == 0 || brightness[n - 1 - n / 10] <= 1) return;
    print_note(
        formatted("warning: more than a tenth of the objects' pixels is brighter than white; --exposure %.1f makes the "
                  "brightest hundredth white",
                  exposure - portable::log(brightness[n - 1 - n / 100]) / portable::log(2)));
}

void PictureRequest::add_options(Options& options) {
    options.add("method", method_names, settings.method);
    options.add("samples", "N", "directions per pixel (default 40)", settings.samples, 1, most_lattice_samples);
    options.add("pool", "K", "Gaussian processes of --method pool (default 20)", settings.pool, 1, 1000);
    add_model_options(options, settings);
    options.add({"size", "WxH", "in pixels, or W for a square (default 500x500)",
                 [this](const std::string& text) { set_size(settings, text); }});
    options.add("environment", "FILE", environment_help, environment);
    options.add("exposure", "X", "brighten a PPM or BMP by X stops (default 0)", exposure, -200, 200);
    options.add("format", format_names, format, ": sRGB, linear floats, sRGB for any viewer");
    options.add("threads", "T", "number of threads; the picture does not change (default: all processors)",
                settings.threads, 1, 256);
    const std::string method = std::string("--method ") + name_of(settings.method, method_names);
    if (settings.method == Method::mc)
        options.make_idle({"covariance", "smoothness", "length-scale", "noise", "known"}, method);
    if (settings.method != Method::pool) options.make_idle({"pool"}, method);
    if (format == Format::pfm) options.make_idle({"exposure"}, "--format pfm");
}

std::string PictureRequest::report() const {
    require_possible();
    return file(image(load_environment(environment, settings.threads)));
}

std::size_t PictureRequest::most_samples() const {
    return settings.method == Method::mc && shared_count(settings) > 0 ? most_lattice_samples : max_process_samples;
}

void PictureRequest::require_possible() const {
    if (settings.samples > most_samples())
        throw std::invalid_argument(formatted(
            "--samples: '%zu' is too many: at most 4096, except with --method mc on a lattice", settings.samples));
}

Image PictureRequest::image(const EnvironmentMap& light) const { return warned_picture(light, settings); }

std::string PictureRequest::file(Image image) const {
    if (format != Format::pfm) {
        const double factor = portable::pow(2, exposure);
        for (Color& pixel : image.pixels) pixel = factor * pixel;
        warn_of_exposure(image, exposure);
    }
    return encode(image, format);
}

std::string two_digits(double number) {
    return formatted("%.9g", std::floor(std::strtod(formatted("%.1e", number).c_str(), nullptr) + 0.5));
}

// Prints a note on what to expect of so many samples of this light where it is not known, if they miss it: the contrast
// c is above sqrt(samples) / 2, so that the error is above half of the picture's brightness. It ends with the cure.
static void note_missed_light(const EnvironmentMap& light, std::size_t samples, const char* cure) {
    const double c = contrast(light), root = std::sqrt(static_cast<double>(samples));
    if (c > root / 2)
        print_note("note: expect an error of about " + two_digits(100 * c / root) + " % of the picture's brightness " +
                   formatted("with %zu samples: the standard deviation of the light is %.2g times its mean%s", samples,
                             c, cure));
}

// Prints a warning if the error of these rules is more than twice that of Monte Carlo with as many samples in one of
// two worlds, a white one or one of noise (white_brightness, noise_gain): in the mean over the shared rules, or over
// some fresh ones where pixels share none: twenty, or fewer if they are large.
static void warn_of_weights(const PixelRules& rules) {
    SharedRules examined = rules.shared;
    const std::size_t fresh = std::clamp<std::size_t>(8000 / rules.settings.samples, 2, 20);  // so that none wait
    for (int x = 0; x < static_cast<int>(fresh) && rules.shared.empty(); ++x) {
        Random random = pixel_stream(rules.settings, x, 0);
        examined.push_back(rules.fresh_rule(random));
    }
    RootMeanSquare gain;
    Statistics brightness;
    for (const auto& rule : examined) {
        gain.add(noise_gain(*rule));
        brightness.add(white_brightness(*rule));
    }
    const double excess = brightness.mean - 1;
    const double of_monte_carlo = 1 / std::sqrt(3 * static_cast<double>(rules.settings.samples));
    std::string harm;
    if (gain.value() > 2)
        harm = "the weights amplify errors of samples " + two_digits(gain.value()) + " times as much as Monte Carlo's";
    else if (std::fabs(excess) > 2 * of_monte_carlo)
        harm = formatted("the weights make a white world %.0f %% too %s, more than twice Monte Carlo's error",
                         100 * std::fabs(excess), excess < 0 ? "dark" : "bright");
    if (!harm.empty()) print_note("warning: " + harm + "; take the default method, covariance and noise");
}

Image warned_picture(const EnvironmentMap& light, const RenderSettings& settings, const char* cure) {
    note_missed_light(light, settings.samples, cure);
    const PixelRules rules(settings);
    warn_of_weights(rules);
    return render(light, settings, environment_shader(light, rules));
}
}  // namespace bmc
