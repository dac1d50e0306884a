#include "judge/judge.h"

#include "judge/judge_picture.h"
#include "scene/desert.h"
#include "scene/input.h"

#include <istream>
#include <optional>

namespace {

std::string picture_report(const PictureJudgement& judgement) {
    std::string text = "# quantity           here     expected       spread   accepted from and to\n", outside;
    for (const Quantity& q : judgement.comparison.quantities) {
        text += line("%-12s %12.5g %12.5g %12.5g %12.5g %12.5g\n", q.name.c_str(), q.here, q.expected, q.spread, q.low,
                     q.high);
        if (!q.fits()) outside += (outside.empty() ? "" : ", ") + q.name;
    }
    const Lag lag = lag_of(judgement.comparison.strangest);
    text += line(
        "# The block that errs most is around column %d, row %d; \"repeats\" is of pixels %d columns and %d rows "
        "apart.\n",
        judgement.block.x, judgement.block.y, lag.x, lag.y);
    if (judgement.fits()) return text + "# Verdict: within what correct programs do.\n";
    return text + "# Verdict: not what correct programs do, by " + outside +
           (judgement.mistake.empty() ? "" : "; likely: " + judgement.mistake) + ".\n";
}

}  // namespace

std::vector<Option> Judge::options() {
    const RenderOptions render_options(correct);
    return joined({{name_option("", "FILE", "a picture, PPM or PFM (-: standard input)", file), render_options.method,
                    render_options.samples, render_options.pool,
                    name_option("environment", "FILE", "the picture's light: a Radiance .hdr file, or bright-desert",
                                environment)},
                   render_options.process,
                   {render_options.placement}});
}

Outcome Judge::report() const {
    if (file.empty()) throw UsageError("judge: name the file to judge, as in ./workbench judge out.ppm");
    require_possible(correct);
    if (correct.samples > 1000) throw UsageError("judge: --samples: at most 1000 can be judged");
    const EnvironmentMap light = load_environment(environment);
    std::optional<PictureFile> picture;
    read_input(file, [&](std::istream& in) { picture = read_picture(in); });
    const PictureJudgement judgement = judge_picture(*picture, light, correct, terminal_progress("workbench"));
    const std::string codes = picture->maxval > 0 ? line("codes to %d", picture->maxval) : "linear floats";
    return {line("# %d x %d pixels, %s, beside correct ones of %s\n", picture->image.width(), picture->image.height(),
                 codes.c_str(), options_of(correct).c_str()) +
                picture_report(judgement),
            judgement.fits() ? 0 : 1};
}
