#include "judge/judge.h"

#include "experiments/error_table.h"
#include "experiments/input.h"
#include "judge/correct_pictures.h"
#include "judge/judge_picture.h"
#include "judge/judge_table.h"
#include "scene/desert.h"

#include <istream>
#include <optional>

namespace {

std::string picture_report(const PictureJudgement& judgement, const std::string& wanted) {
    std::string text = "# quantity           here     expected       spread   accepted from and to\n", outside;
    for (const Quantity& q : judgement.quantities) {
        text += line("%-12s %12.5g %12.5g %12.5g %12.5g %12.5g\n", q.name, q.here, q.expected, q.spread, q.low, q.high);
        if (!q.fits()) outside += (outside.empty() ? "" : ", ") + std::string(q.name);
    }
    text += line("# The block that errs most is around column %d, row %d.\n", judgement.block_x, judgement.block_y) +
            (judgement.resembles.empty() ? "" : "# The numbers resemble most those of " + judgement.resembles + ".\n");
    if (judgement.fits() && judgement.resembles != wanted) text += "# But not so much as to tell which it is.\n";
    if (judgement.fits()) return text + "# Verdict: within what correct programs do.\n";
    return text + "# Verdict: not what correct programs do, by " + outside +
           (judgement.mistake.empty() ? "" : "; likely: " + judgement.mistake) + ".\n";
}

}  // namespace

std::vector<Option> Judge::options() {
    std::vector<Option> options = {
        {"", "FILE", "a picture (PPM or PFM) or, with --integrand, a table (-: standard input)",
         [this](const std::string& text) { file = parse_name(text); }},
        {"integrand", "NAME", "the file is the error table of constant, cosine, cosine-cubed or environment",
         [this](const std::string& text) { integrand = parse_name(text); }}};
    std::vector<Option> of_picture = correct.method_options();
    of_picture.push_back({"environment", "FILE", "the picture's light: a Radiance .hdr file, or bright-desert",
                          [this](const std::string& text) { environment = parse_name(text); }});
    for (Option& option : of_picture) {
        option.idle = [this, idle = option.idle] {
            if (!integrand.empty()) return std::string("an error table has none");
            return idle ? idle() : std::string();
        };
        options.push_back(std::move(option));
    }
    for (Option& option : correct.model_options())
        if (option.name != "seed") options.push_back(std::move(option));
    return options;
}

Outcome Judge::report() const {
    if (file.empty()) throw UsageError("judge: name the file to judge, as in ./workbench judge out.ppm");
    const RenderSettings settings = correct.chosen();
    const std::unique_ptr<Covariance> covariance = correct.model.make_covariance();
    return integrand.empty() ? judge_picture_file(settings, *covariance) : judge_table_file(settings, *covariance);
}

Outcome Judge::judge_picture_file(RenderSettings settings, const Covariance& covariance) const {
    if (settings.samples > 1000) throw UsageError("judge: --samples: at most 1000 can be judged");
    const EnvironmentMap light = load_environment(environment);
    std::optional<PrefilteredEnvironment> prefiltered;
    if (correct.light_known) settings.light = &prefiltered.emplace(light);
    std::optional<Picture> picture;
    read_input(file, [&](std::istream& in) {
        if (in.peek() != 'P') throw std::runtime_error("neither a PPM nor a PFM; for a table give --integrand NAME");
        picture = read_picture(in);
    });
    const PictureJudgement judgement =
        judge_picture(*picture, light, covariance, settings, terminal_progress("workbench"));
    const std::string codes = picture->maxval > 0 ? line("codes to %d", picture->maxval) : "linear floats";
    return {line("# %d x %d pixels, %s, beside correct ones of %s\n", picture->image.width(), picture->image.height(),
                 codes.c_str(), options_of(settings).c_str()) +
                picture_report(judgement, options_of(settings)),
            judgement.fits() ? 0 : 1};
}

Outcome Judge::judge_table_file(const RenderSettings& settings, const Covariance& covariance) const {
    if (correct.light_known) throw UsageError("judge: --known light: an error table has no light to be known");
    const Integrand chosen = integrands_named(integrand).front();
    TableJudgement judgement;
    read_input(file, [&](std::istream& in) {
        const std::vector<Row> rows = read_rows(in, 1000);
        judgement = judge_table(rows, chosen, covariance, settings.noise, settings.placement, settings.prior);
    });
    return {"# integral of " + chosen.formula +
                line(" = %.10f, beside means of 100 errors (MC) and of 10 (BMC)\n", chosen.truth) +
                table_report(judgement),
            judgement.fits() ? 0 : 1};
}
