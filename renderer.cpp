// Renders the sphere scene with Monte Carlo or Bayesian Monte Carlo and writes the picture to standard output.
#include "numerics/portable_math.h"

#include "command_line.h"
#include "light/desert.h"
#include "numerics/plain_loops.h"
#include "prediction.h"

#include <algorithm>
#include <thread>

using namespace bmc;

namespace {

struct Request {
    PictureSettings settings;
    Prediction prediction;
    std::string environment = built_in_lights[0];
    Format format = Format::ppm;
    bool help = false;
};

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
    const PictureOptions options(request.settings);
    const auto chosen = [&] { return request.prediction.rmse > 0 ? "--rmse chooses their number" : ""; };
    const PredictionOptions prediction(request.prediction);
    return {options.method, useless_while(chosen, options.samples), prediction.rmse, options.pool, options.share};
}

std::vector<Option> picture_options(Request& request) {
    PictureSettings& settings = request.settings;
    return {
        {"size", "WxH", "in pixels, or W for a square (default 500x500)",
         [&](const std::string& text) { set_size(settings, text); }},
        name_option("environment", "FILE", environment_help, request.environment),
        PredictionOptions(request.prediction).show,
        {"format", "NAME", "ppm (8-bit sRGB, default) or pfm (linear floats)",
         [&](const std::string& text) { request.format = parse_choice(text, format_names); }},
        count_option("threads", "T", "changes the time only, not the picture (default: all cores)", settings.threads,
                     256),
        {"plain", "", "the textbook's loops: slower, the same bytes", [](const std::string&) { plain_loops = true; }},
        {"help", "", "this text", [&](const std::string&) { request.help = true; }}};
}

std::vector<Option> process_options(Request& request) {
    const PictureOptions options(request.settings);
    return join({options.process, {options.placement, options.seed}});
}

std::string help_text() {
    Request request;
    return "usage: ./renderer [options] > out.ppm\n\n"
           "Renders the sphere scene by Monte Carlo or Bayesian Monte Carlo integration.\n\nmethod:\n" +
           describe(method_options(request)) + "\nGaussian process and its samples:\n" +
           describe(process_options(request)) + "\npicture:\n" + describe(picture_options(request)) +
           "\nexamples: ./renderer --method mc > mc.ppm\n"
           "          ./renderer --method mc --known light --placement cosine-fibonacci \\\n"
           "              --share > best.ppm\n";
}

// Throws UsageError.
Request parse(int argc, char** argv) {
    Request request;
    request.settings.threads = std::max(1u, std::thread::hardware_concurrency());
    request.settings.progress = terminal_progress("renderer");
    const std::vector<std::string> rest =
        parse_options(argc, argv, join({method_options(request), process_options(request), picture_options(request)}));
    if (request.help) return request;
    if (!rest.empty()) throw UsageError("unexpected argument '" + rest[0] + "'; options begin with --");
    require_possible(request.settings);
    return request;
}

std::string run(const Request& request) {
    if (request.help) return help_text();
    require_file_output("./renderer > out.ppm");
    const PictureSettings& settings = request.settings;
    const EnvironmentMap environment = load_environment(request.environment, settings.threads);
    const Image image = asked_picture(environment, settings, request.prediction, request.format);
    return request.format == Format::ppm ? to_ppm(image) : to_pfm(image);
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("renderer", [&] { return run(parse(argc, argv)); });
}
