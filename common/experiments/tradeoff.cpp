#include "experiments/tradeoff.h"

#include "experiments/integral_cost.h"
#include "scene/desert.h"

namespace {

const char* const meaning =
    "# Against a dense quadrature, over 4 to 64 seeds. rmse: linear, over the pixels that show an object, with its\n"
    "# standard error; predicted: the rmse that 4 pictures predict; within: the share of their errors within two\n"
    "# predicted ones; brightness: root mean square of the mean's relative error; correlation: of the errors of\n"
    "# neighbouring pixels, less their mean; mc_samples: samples with which mc has this rmse.\n";
const char* const measured =
    "# Measured here: seconds for a million pixels of objects on one core; efficiency, 1 / (rmse^2 seconds), is that\n"
    "# relative to mc.\n";

}  // namespace

std::vector<Option> Tradeoff::options() {
    return {name_option("environment", "FILE", std::string(environment_help) + " (default: each built-in light)",
                        environment),
            count_option("size", "W", "of the pictures, W x W pixels (default 64)", costs.size, 1024, 2),
            {"seed", "K", "other random numbers for other K (default 1)",
             [this](const std::string& text) { costs.seed = parse_seed(text); }},
            {"all", "",
             "every setting with 10 to 160 samples, and what --rmse gives, under one light (default: the desert)",
             [this](const std::string&) { all = true; }},
            {"no-times", "", "leave out what is measured and differs from run to run",
             [this](const std::string&) { costs.timed = false; }}};
}

std::string Tradeoff::report() const {
    std::vector<std::string> names{environment};
    if (environment.empty()) names = all ? std::vector<std::string>{"desert"} : built_in_lights();
    const Progress progress = terminal_progress("workbench");
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto light = std::make_shared<const EnvironmentMap>(load_environment(names[i]));
        if (i == 0)
            text = "# What an integral costs: " + names[i] + " above a tilted surface, Sobolev 3/2, noise 0.01.\n" +
                   integral_report(integral_costs(environment_integrand(light), costs.seed, costs.timed), costs.timed);
        const auto share = [&](double done) {
            if (progress) progress((static_cast<double>(i) + done) / static_cast<double>(names.size()));
        };
        text += "\n\n# What a picture costs: the sphere scene, " + line("%d x %d pixels, ", costs.size, costs.size) +
                "under " + names[i] + ".\n" + meaning + (costs.timed ? measured : "");
        text +=
            all ? picture_table(picture_costs(*light, all_settings(), {10, 20, 40, 80, 160}, costs, share), costs.timed)
                : paired_table(picture_costs(*light, main_settings(), {10, 40}, costs, share), costs.timed);
        if (all)
            text +=
                "\n\n# Samples that ./renderer --rmse takes for what is asked, and what 4 pictures with them have.\n" +
                asked_table(*light, costs);
    }
    return text;
}
