// Renders the sphere scene with Monte Carlo or Bayesian Monte Carlo and writes the picture to standard output.
#include "base/portable_math.h"

#include "command_line/command_line.h"
#include "known_light/known_light.h"
#include "scene/advice.h"

using namespace bmc;

static void set_size(RenderSettings& settings, const std::string& text) {
    const std::size_t cross = text.find('x');
    settings.width = parse<int>(text.substr(0, cross), 1, 8192);
    settings.height = cross == std::string::npos ? settings.width : parse<int>(text.substr(cross + 1), 1, 8192);
}

// The known light cancels what the weights do to a white world, and no light is too uneven for it: nothing to warn of.
static Image picture_by_known_light(const EnvironmentMap& light, const RenderSettings& settings) {
    const KnownLight known = known_light(light, settings.samples, settings.threads);
    return render(light, settings, known_light_shader(known, settings));
}

static Image picture_by_rules(const EnvironmentMap& light, const RenderSettings& settings) {
    note_uneven_light(light, settings.samples);
    const PixelRules rules(settings);
    warn_of_weights(rules);
    return render(light, settings, environment_shader(light, rules));
}

static const char* const usage = R"(usage: ./renderer [options] > out.ppm
       ./renderer --method direct --samples 20 --size 100 > direct.ppm

Renders the sphere scene with Monte Carlo or Bayesian Monte Carlo. The methods:
  mc       Monte Carlo: random directions for each pixel, all of equal weight
  direct   Bayesian Monte Carlo, with a new Gaussian process for each pixel
  single   one Gaussian process for all pixels, turned to the normal
  rotated  the same, rotated about the normal by a random angle in each pixel
  pool     in each pixel one of several Gaussian processes, rotated by a random angle
)";

static std::string run(const std::vector<std::string>& words) {
    RenderSettings settings;
    std::string environment = built_in_lights[0];
    double exposure = 0;
    Format format = Format::ppm;
    Arguments arguments{words, usage};
    arguments.add("method", method_names, settings.method);
    arguments.add("samples", "N", "directions per pixel", settings.samples, 1, max_process_samples);
    arguments.add("pool", "K", "Gaussian processes of --method pool", settings.pool, 1, 1000);
    add_model_options(arguments, settings, {"nothing", "cosine", "light"});
    arguments.add({"size", "WxH",
                   formatted("in pixels, or W for a square (default %dx%d)", settings.width, settings.height),
                   [&](const std::string& text) { set_size(settings, text); }});
    arguments.add("environment", "FILE", environment_help(), environment);
    arguments.add("exposure", "X", "brighten a PPM or BMP by X stops", exposure, -200, 200);
    arguments.add("format", format_names, format, ": sRGB, linear floats, sRGB for any viewer");
    arguments.add({"threads", "T", "number of threads; the picture does not change (default: all processors)",
                   [&](const std::string& text) { settings.threads = parse<std::size_t>(text, 1, 256); }});
    const auto is_mc = [&] { return settings.method == Method::mc; };
    const auto is_light_known = [&] { return arguments.given["known"] == "light"; };
    arguments.make_idle({"covariance", "smoothness", "length-scale", "noise"}, "with --method mc", is_mc);
    arguments.make_idle({"known"}, "with --method mc", [&] { return is_mc() && !is_light_known(); });
    arguments.make_idle({"pool"}, "without --method pool", [&] { return settings.method != Method::pool; });
    arguments.make_idle({"pool"}, "with a lattice or an optimised set", [&] { return settings.placement.is_fixed(); });
    arguments.make_idle({"exposure"}, "with --format pfm", [&] { return format == Format::pfm; });
    arguments.take("out.ppm");

    const EnvironmentMap light = load_environment(environment, settings.threads);
    Image image = is_light_known() ? picture_by_known_light(light, settings) : picture_by_rules(light, settings);
    if (format != Format::pfm) {  // a PFM has the radiance itself
        const double factor = portable::pow(2, exposure);
        for (Colour& pixel : image.pixels) pixel = factor * pixel;
        warn_of_exposure(image, exposure);
    }
    return encode(image, format);
}

int main(int argc, char** argv) { return run_program("renderer", run, {argv, argv + argc}); }
