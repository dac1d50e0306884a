#include "scene/picture_request.h"

#include "base/statistics.h"
#include "light/texels_on_sphere.h"
#include "scene/known_light.h"

namespace bmc {
// The standard deviation of the light over its mean, where a direction counts by cos(theta) on the rectangle, whose
// normal is +y, and on the side of the sphere that the camera sees, whose mean normal is +z. Of a texel, the solid
// angle is in proportion to the sine of the polar angle.
static double contrast(const EnvironmentMap& light) {
    const TexelsOnSphere texels(light);
    std::vector<double> towards_camera;
    for (int column = 0; column < texels.columns; ++column)
        towards_camera.push_back(-texels.azimuth(column + 0.5).cosine);
    Vec3 sums;  // of the weights, and of brightness and its square with these weights
    for (int row = 0; row < texels.rows; ++row) {
        const auto [sine, cosine] = texels.polar(row + 0.5);
        for (int column = 0; column < texels.columns; ++column) {
            const double seen = std::max(0.0, cosine) + std::max(0.0, sine * towards_camera[std::size_t(column)]);
            const double b = brightness(texels(row, column));
            sums += sine * seen * Vec3{1, b, b * b};
        }
    }
    return std::sqrt(std::max(0.0, sums.x * sums.z / (sums.y * sums.y) - 1));
}

bool note_missed_light(const EnvironmentMap& light, std::size_t samples) {
    const double c = contrast(light), lamp = 1 / (1 + c * c), n = static_cast<double>(samples);
    if (!(c > std::sqrt(n) / 2)) return false;
    print_note(
        formatted("note: on these objects the light is as uneven as one lamp's in %.2g %% of all directions, where "
                  "%.2g of %zu random samples look; its standard deviation is %.3g times its mean",
                  100 * lamp, n * lamp, samples, c));
    return true;
}

// On average over the shared rules, or over four fresh ones where pixels share none.
static void warn_of_weights(const PixelRules& rules) {
    SharedRules examined = rules.shared;
    for (int x = 0; x < 4 && rules.shared.empty(); ++x) {
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
    const double monte_carlo_error = 1 / std::sqrt(3 * static_cast<double>(rules.settings.samples));
    std::string harm;
    if (gain.value() > 2)
        harm = "the weights amplify errors of samples " + two_digits(gain.value()) + " times as much as Monte Carlo's";
    else if (std::fabs(excess) > 2 * monte_carlo_error)
        harm = formatted("the weights make a white world %.0f %% too %s, more than twice Monte Carlo's error",
                         100 * std::fabs(excess), excess < 0 ? "dark" : "bright");
    if (!harm.empty()) print_note("warning: " + harm + "; take the default method, covariance and noise");
}

Image warned_picture(const EnvironmentMap& light, const RenderSettings& settings) {
    const PixelRules rules(settings);
    warn_of_weights(rules);
    return render(light, settings, environment_shader(light, rules));
}

void warn_of_exposure(const Image& image, double exposure) {
    const auto brightest_channel = [](Colour pixel) { return std::max({pixel.x, pixel.y, pixel.z}); };
    const auto above_white = [&](Colour pixel) { return brightest_channel(pixel) > 1; };
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

static void set_size(RenderSettings& settings, const std::string& text) {
    const std::size_t cross = text.find('x');
    settings.width = parse<int>(text.substr(0, cross), 1, 8192);
    settings.height = cross == std::string::npos ? settings.width : parse<int>(text.substr(cross + 1), 1, 8192);
}

void PictureRequest::add_options(Arguments& arguments) {
    arguments.add("method", method_names, settings.method);
    arguments.add("samples", "N", "directions per pixel", settings.samples, 1, max_process_samples);
    arguments.add("pool", "K", "Gaussian processes of --method pool", settings.pool, 1, 1000);
    add_model_options(arguments, settings, &light_known);
    arguments.add({"size", "WxH",
                   formatted("in pixels, or W for a square (default %dx%d)", settings.width, settings.height),
                   [this](const std::string& text) { set_size(settings, text); }});
    arguments.add("environment", "FILE", environment_help(), environment);
    arguments.add("exposure", "X", "brighten a PPM or BMP by X stops", exposure, -200, 200);
    arguments.add("format", format_names, format, ": sRGB, linear floats, sRGB for any viewer");
    arguments.add({"threads", "T", "number of threads; the picture does not change (default: all processors)",
                   [this](const std::string& text) { settings.threads = parse<std::size_t>(text, 1, 256); }});
    arguments.make_idle({"covariance", "smoothness", "length-scale", "noise"}, "with --method mc",
                        [this] { return settings.method == Method::mc; });
    arguments.make_idle({"known"}, "with --method mc",
                        [this] { return settings.method == Method::mc && !light_known; });
    arguments.make_idle({"pool"}, "without --method pool", [this] { return settings.method != Method::pool; });
    arguments.make_idle({"pool"}, "with a lattice or an optimised set",
                        [this] { return settings.placement.is_fixed(); });
    arguments.make_idle({"exposure"}, "with --format pfm", [this] { return format == Format::pfm; });
}

std::string PictureRequest::report(Arguments& arguments) {
    add_options(arguments);
    arguments.take("out.ppm");
    const EnvironmentMap light = load_environment(environment, settings.threads);
    if (!light_known && note_missed_light(light, settings.samples)) print_note("note: --known light models this light");
    // A known light is a quotient, which cancels what warned_picture warns of.
    Image picture =
        light_known ? render(light, settings, known_light_shader(light, settings)) : warned_picture(light, settings);
    if (format != Format::pfm) {
        const double factor = portable::pow(2, exposure);
        for (Colour& pixel : picture.pixels) pixel = factor * pixel;
        warn_of_exposure(picture, exposure);
    }
    return encode(picture, format);
}
}  // namespace bmc
