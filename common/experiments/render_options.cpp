#include "experiments/render_options.h"

#include <tuple>

namespace {

constexpr long max_mc_samples = 1000000;

// What is known of the integrand, and whether the light is known besides.
constexpr std::pair<const char*, std::pair<KnownPart, bool>> known_names[] = {{"nothing", {KnownPart::nothing, false}},
                                                                              {"cosine", {KnownPart::cosine, false}},
                                                                              {"light", {KnownPart::cosine, true}}};

}  // namespace

std::vector<Option> RenderOptions::method_options() {
    return {
        {"method", "NAME", choices(method_names, settings.method),
         [this](const std::string& text) { settings.method = parse_choice(text, method_names); }},
        {"samples", "N", "directions per pixel (default 40)",
         [this](const std::string& text) {
             settings.samples = static_cast<std::size_t>(parse_integer(text, 1, max_mc_samples));
         }},
        {"pool", "K", "Gaussian processes in the pool (default 20)",
         [this](const std::string& text) { settings.pool = static_cast<std::size_t>(parse_integer(text, 1, 1000)); },
         [this] { return settings.method == Method::pool ? "" : "it belongs to --method pool"; }}};
}

void RenderOptions::add_known_light(Option& known) {
    known.description = "part of the integrand: " + choices(known_names, {KnownPart::nothing, false}) +
                        "; the last two for sobolev with smoothness 1.5";
    known.set = [this](const std::string& text) {
        std::tie(model.prior.known, light_known) = parse_choice(text, known_names);
    };
}

std::vector<Option> RenderOptions::model_options() {
    std::vector<Option> options = model.options();
    for (Option& option : options) {
        if (option.name == "known") add_known_light(option);
        if (option.name == "placement" || option.name == "seed") continue;
        option.idle = [this, idle = option.idle, known = option.name == "known"] {
            if (settings.method == Method::mc && !(known && light_known))
                return std::string("--method mc makes no Gaussian process");
            return idle ? idle() : std::string();
        };
    }
    return options;
}

RenderSettings RenderOptions::chosen() const {
    if (settings.method != Method::mc && settings.samples > max_process_samples)
        throw UsageError("--samples: " + std::to_string(settings.samples) + " are too many, at most " +
                         std::to_string(max_process_samples) + " are allowed for every method but mc");
    RenderSettings all = settings;
    all.placement = model.placement;
    all.noise = model.noise;
    all.prior = model.prior;
    all.seed = model.seed;
    return all;
}
