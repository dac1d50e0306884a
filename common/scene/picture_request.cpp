#include "scene/picture_request.h"

#include "scene/advice.h"

namespace bmc {
static void set_size(RenderSettings& settings, const std::string& text) {
    const std::size_t cross = text.find('x');
    settings.width = parse<int>(text.substr(0, cross), 1, 8192);
    settings.height = cross == std::string::npos ? settings.width : parse<int>(text.substr(cross + 1), 1, 8192);
}

void PictureRequest::add_options(Options& options) {
    options.add("method", method_names, settings.method);
    options.add("samples", "N", "directions per pixel", settings.samples, 1, max_process_samples);
    options.add("pool", "K", "Gaussian processes of --method pool", settings.pool, 1, 1000);
    add_model_options(options, settings);
    options.add({"size", "WxH",
                 formatted("in pixels, or W for a square (default %dx%d)", settings.width, settings.height),
                 [this](const std::string& text) { set_size(settings, text); }});
    options.add("environment", "FILE", environment_help(), environment);
    options.add("exposure", "X", "brighten a PPM or BMP by X stops", exposure, -200, 200);
    options.add("format", format_names, format, ": sRGB, linear floats, sRGB for any viewer");
    options.add({"threads", "T", "number of threads; the picture does not change (default: all processors)",
                 [this](const std::string& text) { settings.threads = parse<std::size_t>(text, 1, 256); }});
    options.make_idle({"covariance", "smoothness", "length-scale", "noise", "known"}, "with --method mc",
                      [this] { return settings.method == Method::mc; });
    options.make_idle({"pool"}, "without --method pool", [this] { return settings.method != Method::pool; });
    options.make_idle({"pool"}, "with a lattice or an optimised set", [this] { return settings.placement.is_fixed(); });
    options.make_idle({"exposure"}, "with --format pfm", [this] { return format == Format::pfm; });
}

std::string PictureRequest::report() const {
    Image picture = image(load_environment(environment, settings.threads));
    if (format != Format::pfm) {
        const double factor = portable::pow(2, exposure);
        for (Colour& pixel : picture.pixels) pixel = factor * pixel;
        warn_of_exposure(picture, exposure);
    }
    return encode(picture, format);
}

Image PictureRequest::image(const EnvironmentMap& light) const {
    note_missed_light(light, settings.samples);
    return render(light, settings, warned_shader(light, settings));
}
}  // namespace bmc
