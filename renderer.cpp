// Renders the sphere scene with Monte Carlo or Bayesian Monte Carlo and writes the picture to standard output.
#include "numerics/portable_math.h"

#include "command_line.h"
#include "numerics/plain_loops.h"
#include "options.h"
#include "scene/desert.h"

#include <algorithm>
#include <thread>

namespace {

struct Request {
    PictureSettings settings;
    double rmse = 0;  // that is asked for; 0: the number of samples is given
    std::string environment = built_in_lights[0];
    bool linear = false;  // PFM instead of PPM
    bool help = false;
};

constexpr std::pair<const char*, bool> format_names[] = {{"ppm", false}, {"pfm", true}};
constexpr long max_side = 8192;

void set_size(PictureSettings& settings, const std::string& text) {
    const std::size_t cross = text.find('x');
    try {
        settings.width = static_cast<int>(parse_integer(text.substr(0, cross), 1, max_side));
        settings.height = settings.width;
        if (cross != std::string::npos)
            settings.height = static_cast<int>(parse_integer(text.substr(cross + 1), 1, max_side));
    } catch (const UsageError&) {
        throw UsageError("'" + text + "' is neither WxH nor W, whole numbers from 1 to " + std::to_string(max_side));
    }
}

std::vector<Option> method_options(Request& request) {
    const RenderOptions options(request.settings);
    const auto chosen = [&] { return request.rmse > 0 ? "--rmse chooses their number" : ""; };
    return {options.method, idle_while(chosen, options.samples),
            real_option("rmse", "X", "of the picture, predicted: takes the fewest samples that have at most this",
                        request.rmse, {1e-9, 1e9}),
            options.pool};
}

std::vector<Option> picture_options(Request& request) {
    PictureSettings& settings = request.settings;
    return {
        {"size", "WxH", "in pixels, or W for a square (default 500x500)",
         [&](const std::string& text) { set_size(settings, text); }},
        name_option("environment", "FILE", environment_help, request.environment),
        choice_option("show", "", show_names, settings.show,
                      ": the predicted standard error of every pixel; as PPM black is 0, and white twice the "
                      "picture's RMSE"),
        {"format", "NAME", "ppm (8-bit sRGB, default) or pfm (linear floats)",
         [&](const std::string& text) { request.linear = parse_choice(text, format_names); }},
        count_option("threads", "T", "changes the time only, not the picture (default: all cores)", settings.threads,
                     256),
        {"plain", "", "the textbook's loops: slower, the same bytes", [](const std::string&) { plain_loops = true; }},
        {"help", "", "this text", [&](const std::string&) { request.help = true; }}};
}

std::vector<Option> process_options(Request& request) {
    const RenderOptions options(request.settings);
    return joined({options.process, {options.placement, options.seed}});
}

std::string help_text() {
    Request request;
    return "usage: ./renderer [options] > out.ppm\n\n"
           "Renders the sphere scene by Monte Carlo or Bayesian Monte Carlo integration.\n\nmethod:\n" +
           describe(method_options(request)) + "\nGaussian process and its samples:\n" +
           describe(process_options(request)) + "\npicture:\n" + describe(picture_options(request)) +
           "\nexamples: ./renderer --method mc > mc.ppm\n"
           "          ./renderer --known light --placement cosine-fibonacci > best.ppm\n";
}

// Throws UsageError.
Request parse(int argc, char** argv) {
    Request request;
    request.settings.threads = std::max(1u, std::thread::hardware_concurrency());
    const std::vector<std::string> rest = parse_options(
        argc, argv, joined({method_options(request), process_options(request), picture_options(request)}));
    if (request.help) return request;
    if (!rest.empty()) throw UsageError("unexpected argument '" + rest[0] + "'; options begin with --");
    require_possible(request.settings);
    if (request.rmse > 0 || request.settings.show == Show::error) require_predictable(request.settings);
    return request;
}

void tell_prediction(const PictureSettings& settings, double rmse) {
    std::fprintf(stderr, "renderer: %zu sample%s for a predicted RMSE of %.2g%s\n", settings.samples,
                 settings.samples == 1 ? "" : "s", rmse,
                 settings.method == Method::single ? "; all pixels share one rule, and this seed may be far off" : "");
}

std::string run(Request request) {
    if (request.help) return help_text();
    require_file_output("./renderer > out.ppm");
    PictureSettings& settings = request.settings;
    const EnvironmentMap environment = load_environment(request.environment, settings.threads);
    std::optional<PrefilteredEnvironment> prefiltered;
    if (settings.light_known) prefiltered.emplace(environment, settings.threads);
    const EnvironmentLight light{environment, prefiltered ? &*prefiltered : nullptr};
    const Scene scene = sphere_scene();
    if (request.rmse > 0) {
        const ChosenSamples chosen = samples_for(request.rmse, max_process_samples, scene, light, settings);
        settings.samples = chosen.samples;
        tell_prediction(settings, chosen.rmse);
    }
    Image image = picture(scene, light, settings, terminal_progress("renderer"));
    if (settings.show == Show::error) {
        const double rmse = root_mean_square(image, object_pixels(scene, {settings.width, settings.height}));
        if (request.rmse == 0) tell_prediction(settings, rmse);
        if (!request.linear) image = grey_scale(image, 2 * rmse);
    }
    return request.linear ? to_pfm(image) : to_ppm(image);
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("renderer", [&] { return run(parse(argc, argv)); });
}
