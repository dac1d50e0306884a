// Renders the sphere scene with Monte Carlo or Bayesian Monte Carlo and writes the picture to standard output.
#include "numerics/portable_math.h"

#include "command_line.h"
#include "options.h"
#include "scene/desert.h"
#include "scene/render.h"

#include <algorithm>
#include <thread>

namespace {

struct Request {
    RenderSettings settings;
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
    RenderSettings& settings = request.settings;
    return {{"size", "WxH", "in pixels, or W for a square (default 500x500)",
             [&](const std::string& text) { set_size(settings, text); }},
            {"environment", "FILE", environment_help,
             [&](const std::string& text) { request.environment = parse_name(text); }},
            {"format", "NAME", "ppm (8-bit sRGB, default) or pfm (linear floats)",
             [&](const std::string& text) { request.linear = parse_choice(text, format_names); }},
            {"threads", "T", "changes the time only, not the picture (default: all cores)",
             [&](const std::string& text) { settings.threads = static_cast<unsigned>(parse_integer(text, 1, 256)); }},
            {"plain", "", "the textbook's loops: slower, the same bytes",
             [&](const std::string&) { settings.plain = true; }},
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
           describe(RenderOptions(request.settings).method) + "\nGaussian process and its samples:\n" +
           describe(process_options(request)) + "\npicture:\n" + describe(picture_options(request)) +
           "\nexamples: ./renderer --method mc > mc.ppm\n"
           "          ./renderer --known light --placement cosine-fibonacci > best.ppm\n";
}

// Throws UsageError.
Request parse(int argc, char** argv) {
    Request request;
    request.settings.threads = std::max(1u, std::thread::hardware_concurrency());
    const std::vector<std::string> rest = parse_options(
        argc, argv,
        joined({RenderOptions(request.settings).method, process_options(request), picture_options(request)}));
    if (request.help) return request;
    if (!rest.empty()) throw UsageError("unexpected argument '" + rest[0] + "'; options begin with --");
    require_possible(request.settings);
    return request;
}

std::string run(const Request& request) {
    if (request.help) return help_text();
    require_file_output("./renderer > out.ppm");
    const EnvironmentMap environment = load_environment(request.environment);
    const Image image = render(sphere_scene(), environment, request.settings, terminal_progress("renderer"));
    return request.linear ? to_pfm(image) : to_ppm(image);
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("renderer", [&] { return run(parse(argc, argv)); });
}
