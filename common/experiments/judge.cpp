#include "experiments/judge.h"

#include "experiments/input.h"
#include "experiments/judge_picture.h"
#include "scene/desert.h"

#include <optional>

namespace {

std::string picture_report(const PictureJudgement& judgement) {
    std::string text = "# quantity           here     expected       spread   accepted from and to\n", outside;
    for (const Quantity& q : judgement.quantities) {
        text += line("%-12s %12.5g %12.5g %12.5g %12.5g %12.5g\n", q.name, q.here, q.expected, q.spread, q.low, q.high);
        if (!q.fits()) outside += (outside.empty() ? "" : ", ") + std::string(q.name);
    }
    text += line("# The block that errs most is around column %d, row %d.\n", judgement.block_x, judgement.block_y) +
            "# The numbers resemble most those of " + judgement.resembles + ".\n";
    if (judgement.fits()) return text + "# Verdict: within what correct programs do.\n";
    return text + "# Verdict: not what correct programs do, by " + outside +
           (judgement.mistake.empty() ? "" : "; likely: " + judgement.mistake) + ".\n";
}

}  // namespace

std::vector<Option> Judge::options() {
    std::vector<Option> options = {
        {"", "FILE", "a picture (PPM or PFM) or, with --integrand, a table (-: standard input)",
         [this](const std::string& text) { file = parse_name(text); }},
        {"environment", "FILE", "the picture's light, in place of the built-in desert",
         [this](const std::string& text) { environment = parse_name(text); }}};
    for (const auto& group : {correct.method_options(), correct.model_options()})
        for (const Option& option : group)
            if (option.name != "seed") options.push_back(option);
    return options;
}

Outcome Judge::report() const {
    if (file.empty()) throw UsageError("judge: name the file to judge, as ./workbench judge out.ppm");
    RenderSettings settings = correct.chosen();
    const std::unique_ptr<Covariance> covariance = correct.model.make_covariance();
    const EnvironmentMap light = load_environment(environment);
    std::optional<PrefilteredEnvironment> prefiltered;
    if (correct.light_known) settings.light = &prefiltered.emplace(light);
    std::optional<Picture> picture;
    read_input(file, [&](std::istream& in) { picture = read_picture(in); });
    const PictureJudgement judgement =
        judge_picture(*picture, light, *covariance, settings, terminal_progress("workbench"));
    return {
        line("# %s, %d x %d pixels, ", file.substr(0, 200).c_str(), picture->image.width(), picture->image.height()) +
            (picture->maxval > 0 ? line("codes to %d", picture->maxval) : "linear floats") +
            line(", beside correct ones of --method %s --samples %zu\n", name_of(settings.method, method_names),
                 settings.samples) +
            picture_report(judgement),
        judgement.fits() ? 0 : 1};
}
