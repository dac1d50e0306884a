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

// All options, under the titles that they have in the help text.
std::vector<std::pair<std::string, std::vector<Option>>> option_groups(Request& request) {
    PictureSettings& settings = request.settings;
    const PictureOptions of_picture(settings);
    double& rmse = request.prediction.rmse;
    const auto chosen = [&rmse] { return rmse > 0 ? "--rmse chooses their number" : ""; };
    return {
        {"method",
         {of_picture.method, useless_while(chosen, of_picture.samples),
          real_option("rmse", "X", "take the fewest samples whose predicted RMSE is at most X", rmse, {1e-9, 1e9}),
          of_picture.pool, of_picture.share}},
        {"Gaussian process and its samples",
         join({of_picture.process, {of_picture.known, of_picture.placement, of_picture.seed}})},
        {"picture",
         {{"size", "WxH", "in pixels, or W for a square (default 500x500)",
           [&](const std::string& text) { set_size(settings, text); }},
          name_option("environment", "FILE", environment_help, request.environment),
          choice_option("show", "", show_names, request.prediction.show,
                        ": the predicted standard error of every pixel; as PPM black is 0, and white twice the "
                        "picture's RMSE"),
          {"format", "NAME", "ppm (8-bit sRGB, default) or pfm (linear floats)",
           [&](const std::string& text) { request.format = parse_choice(text, format_names); }},
          count_option("threads", "T", "changes the time only, not the picture (default: all cores)", settings.threads,
                       256),
          {"plain", "", "the textbook's loops: slower, the same bytes", [](const std::string&) { plain_loops = true; }},
          {"help", "", "this text", [&](const std::string&) { request.help = true; }}}}};
}

std::string help_text() {
    Request request;
    std::string text =
        "usage: ./renderer [options] > out.ppm\n\n"
        "Renders the sphere scene by Monte Carlo or Bayesian Monte Carlo integration.\n\n";
    for (const auto& [title, options] : option_groups(request)) text += title + ":\n" + describe(options) + '\n';
    return text +
           "examples: ./renderer --method mc > mc.ppm\n"
           "          ./renderer --method mc --known light --placement cosine-fibonacci \\\n"
           "              --share > best.ppm\n";
}

// Throws UsageError.
Request parse(int argc, char** argv) {
    Request request;
    request.settings.threads = std::max(1u, std::thread::hardware_concurrency());
    request.settings.progress = terminal_progress("renderer");
    std::vector<Option> all;
    for (const auto& [title, options] : option_groups(request)) all.insert(all.end(), options.begin(), options.end());
    const std::vector<std::string> rest = parse_options(argc, argv, all);
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
