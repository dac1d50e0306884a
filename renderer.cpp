// Renders the sphere scene with Monte Carlo or Bayesian Monte Carlo and writes the picture to standard output.
#include "numerics/portable_math.h"

#include "command_line.h"
#include "scene/desert.h"
#include "scene/render.h"

#include <optional>
#include <thread>
#include <tuple>

namespace {

struct Request {
    RenderSettings settings;
    ModelOptions model;
    std::unique_ptr<Covariance> covariance;
    std::string environment;  // empty: the built-in one
    bool light_known = false;
    bool linear = false;  // PFM instead of PPM
    bool help = false;
};

constexpr std::pair<const char*, bool> format_names[] = {{"ppm", false}, {"pfm", true}};

// What is known of the integrand, and whether the light is known besides.
constexpr std::pair<const char*, std::pair<KnownPart, bool>> known_names[] = {{"nothing", {KnownPart::nothing, false}},
                                                                              {"cosine", {KnownPart::cosine, false}},
                                                                              {"light", {KnownPart::cosine, true}}};
constexpr long max_side = 8192;
constexpr long max_mc_samples = 1000000;

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

std::vector<Option> method_options(RenderSettings& settings) {
    return {{"method", "NAME", choices(method_names, settings.method),
             [&](const std::string& text) { settings.method = parse_choice(text, method_names); }},
            {"samples", "N", "directions per pixel (default 40)",
             [&](const std::string& text) {
                 settings.samples = static_cast<std::size_t>(parse_integer(text, 1, max_mc_samples));
             }},
            {"pool", "K", "Gaussian processes in the pool (default 20)",
             [&](const std::string& text) { settings.pool = static_cast<std::size_t>(parse_integer(text, 1, 1000)); },
             [&] { return settings.method == Method::pool ? "" : "it belongs to --method pool"; }}};
}

// To the model's nothing and cosine the renderer adds the light.
void add_known_light(Option& known, Request& request) {
    known.description = "part of the integrand: " + choices(known_names, {KnownPart::nothing, false}) +
                        "; the last two for sobolev with smoothness 1.5";
    known.set = [&request](const std::string& text) {
        std::tie(request.model.prior.known, request.light_known) = parse_choice(text, known_names);
    };
}

// Monte Carlo takes from the model where directions are, the seed, and that the light is known.
std::vector<Option> model_options(Request& request) {
    std::vector<Option> options = request.model.options();
    for (Option& option : options) {
        if (option.name == "known") add_known_light(option, request);
        if (option.name == "placement" || option.name == "seed") continue;
        option.idle = [&request, idle = option.idle, known = option.name == "known"] {
            if (request.settings.method == Method::mc && !(known && request.light_known))
                return std::string("--method mc makes no Gaussian process");
            return idle ? idle() : std::string();
        };
    }
    return options;
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
            {"help", "", "this text", [&](const std::string&) { request.help = true; }}};
}

std::vector<Option> options_of(Request& request) {
    std::vector<Option> options;
    for (std::vector<Option> group :
         {method_options(request.settings), model_options(request), picture_options(request)})
        for (Option& option : group) options.push_back(std::move(option));
    return options;
}

std::string help_text() {
    Request request;
    return "usage: ./renderer [options] > out.ppm\n\n"
           "Renders the sphere scene by Monte Carlo or Bayesian Monte Carlo integration.\n\nmethod:\n" +
           describe(method_options(request.settings)) + "\nGaussian process and its samples:\n" +
           describe(model_options(request)) + "\npicture:\n" + describe(picture_options(request)) +
           "\nexamples: ./renderer --method mc > mc.ppm\n"
           "          ./renderer --known light --placement cosine-fibonacci > best.ppm\n";
}

// Throws UsageError.
Request parse(int argc, char** argv) {
    Request request;
    RenderSettings& settings = request.settings;
    settings.threads = std::max(1u, std::thread::hardware_concurrency());
    const std::vector<std::string> rest = parse_options(argc, argv, options_of(request));
    if (request.help) return request;
    if (!rest.empty()) throw UsageError("unexpected argument '" + rest[0] + "'; options begin with --");
    if (settings.method != Method::mc && settings.samples > max_process_samples)
        throw UsageError("--samples: " + std::to_string(settings.samples) + " are too many, at most " +
                         std::to_string(max_process_samples) + " are allowed for every method but mc");
    request.covariance = request.model.make_covariance();
    settings.placement = request.model.placement;
    settings.noise = request.model.noise;
    settings.prior = request.model.prior;
    settings.seed = request.model.seed;
    return request;
}

std::string run(const Request& request) {
    if (request.help) return help_text();
    require_file_output("./renderer > out.ppm");
    const EnvironmentMap environment = load_environment(request.environment);
    RenderSettings settings = request.settings;
    std::optional<PrefilteredEnvironment> light;
    if (request.light_known) settings.light = &light.emplace(environment);
    const Image image =
        render(sphere_scene(), environment, *request.covariance, settings, terminal_progress("renderer"));
    return request.linear ? to_pfm(image) : to_ppm(image);
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("renderer", [&] { return run(parse(argc, argv)); });
}
