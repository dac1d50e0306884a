// Renders the sphere scene with Monte Carlo or Bayesian Monte Carlo and writes the picture to standard output.
#include "common/portable_math.h"

#include "common/command_line.h"
#include "common/render.h"

#include <unistd.h>

#include <thread>

namespace {

struct Request {
    RenderSettings settings;
    ModelOptions model;
    std::string environment;
    bool linear = false;  // PFM instead of PPM
    bool help = false;
};

constexpr long max_side = 8192;
constexpr long max_mc_samples = 1000000;

void set_size(RenderSettings& settings, const std::string& text) {
    const std::size_t cross = text.find('x');
    settings.width = static_cast<int>(parse_integer(text.substr(0, cross), 1, max_side));
    settings.height = cross == std::string::npos ? settings.width
                                                 : static_cast<int>(parse_integer(text.substr(cross + 1), 1, max_side));
}

std::vector<Option> options_of(Request& request) {
    RenderSettings& settings = request.settings;
    std::vector<Option> options = {
        {"method", "NAME", "mc, direct, single, rotated or pool (default)",
         [&](const std::string& text) {
             settings.method = parse_choice<Method>(text, {{"mc", Method::mc},
                                                           {"direct", Method::direct},
                                                           {"single", Method::single},
                                                           {"rotated", Method::rotated},
                                                           {"pool", Method::pool}});
         }},
        {"samples", "N", "directions per pixel (default 40)",
         [&](const std::string& text) {
             settings.samples = static_cast<std::size_t>(parse_integer(text, 1, max_mc_samples));
         }},
        {"pool", "K", "Gaussian processes in the pool (default 20)",
         [&](const std::string& text) { settings.pool = static_cast<std::size_t>(parse_integer(text, 1, 1000)); }},
        {"size", "WxH", "of the picture in pixels, or W for a square (default 500x500)",
         [&](const std::string& text) { set_size(settings, text); }},
        {"environment", "FILE", "light from a Radiance .hdr file instead of the built-in desert",
         [&](const std::string& text) { request.environment = text; }},
        {"format", "NAME", "ppm (8-bit sRGB, default) or pfm (linear floats)",
         [&](const std::string& text) {
             request.linear = parse_choice<bool>(text, {{"ppm", false}, {"pfm", true}});
         }},
        {"threads", "T", "changes the time only, not the picture (default: all cores)",
         [&](const std::string& text) { settings.threads = static_cast<unsigned>(parse_integer(text, 1, 256)); }},
        {"help", "", "this text", [&](const std::string&) { request.help = true; }}};
    for (Option& option : request.model.options()) options.insert(options.end() - 1, std::move(option));
    return options;
}

std::string run(int argc, char** argv) {
    Request request;
    RenderSettings& settings = request.settings;
    settings.threads = std::max(1u, std::thread::hardware_concurrency());
    const std::vector<Option> options = options_of(request);
    const std::vector<std::string> rest = parse_options(argc, argv, options);
    if (request.help)
        return "usage: ./renderer [options] > out.ppm\n\nRenders the sphere scene by Bayesian Monte Carlo "
               "integration.\n\n" +
               describe(options);
    if (!rest.empty()) throw UsageError("unexpected argument '" + rest[0] + "'; options begin with --");
    if (settings.method != Method::mc && settings.samples > max_process_samples)
        throw UsageError("--samples: at most " + std::to_string(max_process_samples) + " for every method but mc");
    if (isatty(STDOUT_FILENO)) throw UsageError("the picture would go to the terminal; write ./renderer > out.ppm");
    const auto covariance = request.model.make_covariance();
    settings.placement = request.model.placement;
    settings.noise = request.model.noise;
    settings.prior = request.model.prior;
    settings.seed = request.model.seed;
    const Image image = render(sphere_scene(), load_environment(request.environment), *covariance, settings,
                               terminal_progress("renderer"));
    return request.linear ? to_pfm(image) : to_ppm(image);
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("renderer", [&] { return run(argc, argv); });
}
