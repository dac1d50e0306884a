// Renders the sphere scene with Monte Carlo or Bayesian Monte Carlo and writes the picture to standard output.
#include "numerics/portable_math.h"

#include "command_line.h"
#include "experiments/render_options.h"
#include "scene/desert.h"
#include "scene/render.h"

#include <algorithm>
#include <optional>
#include <thread>

namespace {

struct Request {
    RenderOptions options;
    RenderSettings settings;  // what they say
    std::unique_ptr<Covariance> covariance;
    std::string environment;  // empty: the built-in one
    bool linear = false;      // PFM instead of PPM
    bool help = false;
};

constexpr std::pair<const char*, bool> format_names[] = {{"ppm", false}, {"pfm", true}};
constexpr long max_side = 8192;

void set_size(RenderSettings& settings, const std::string& text) {
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

std::vector<Option> picture_options(Request& request) {
    RenderSettings& settings = request.options.settings;
    return {{"size", "WxH", "in pixels, or W for a square (default 500x500)",
             [&](const std::string& text) { set_size(settings, text); }},
            {"environment", "FILE", environment_help,
             [&](const std::string& text) { request.environment = parse_name(text); }},
            {"format", "NAME", "ppm (8-bit sRGB, default) or pfm (linear floats)",
             [&](const std::string& text) { request.linear = parse_choice(text, format_names); }},
            {"threads", "T", "changes the time only, not the picture (default: all cores)",
             [&](const std::string& text) { settings.threads = static_cast<unsigned>(parse_integer(text, 1, 256)); }},
            {"help", "", "this text", [&](const std::string&) { request.help = true; }}};
}

std::vector<Option> options_of(Request& request) {
    std::vector<Option> options;
    for (std::vector<Option> group :
         {request.options.method_options(), request.options.model_options(), picture_options(request)})
        for (Option& option : group) options.push_back(std::move(option));
    return options;
}

std::string help_text() {
    Request request;
    return "usage: ./renderer [options] > out.ppm\n\n"
           "Renders the sphere scene by Monte Carlo or Bayesian Monte Carlo integration.\n\nmethod:\n" +
           describe(request.options.method_options()) + "\nGaussian process and its samples:\n" +
           describe(request.options.model_options()) + "\npicture:\n" + describe(picture_options(request)) +
           "\nexamples: ./renderer --method mc > mc.ppm\n"
           "          ./renderer --known light --placement cosine-fibonacci > best.ppm\n";
}

// Throws UsageError.
Request parse(int argc, char** argv) {
    Request request;
    request.options.settings.threads = std::max(1u, std::thread::hardware_concurrency());
    const std::vector<std::string> rest = parse_options(argc, argv, options_of(request));
    if (request.help) return request;
    if (!rest.empty()) throw UsageError("unexpected argument '" + rest[0] + "'; options begin with --");
    request.settings = request.options.chosen();
    request.covariance = request.options.model.make_covariance();
    return request;
}

std::string run(const Request& request) {
    if (request.help) return help_text();
    require_file_output("./renderer > out.ppm");
    const EnvironmentMap environment = load_environment(request.environment);
    RenderSettings settings = request.settings;
    std::optional<PrefilteredEnvironment> light;
    if (request.options.light_known) settings.light = &light.emplace(environment);
    const Image image =
        render(sphere_scene(), environment, *request.covariance, settings, terminal_progress("renderer"));
    return request.linear ? to_pfm(image) : to_ppm(image);
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("renderer", [&] { return run(parse(argc, argv)); });
}
