// Whether pictures of the sphere scene that other programs made are right: each beside correct ones of other seeds.
#include "judge_picture.h"
#include "options.h"
#include "scene/desert.h"
#include "scene/input.h"

namespace {

struct Request {
    std::vector<std::string> files;  // "-": standard input
    std::string environment;         // empty: the built-in one
    PictureSettings correct;          // what correct programs would do
    bool help = false;
};

std::vector<Option> options(Request& request) {
    const RenderOptions of_picture(request.correct);
    return joined({{of_picture.method, of_picture.samples, of_picture.pool, of_picture.placement},
                   of_picture.process,
                   {name_option("environment", "FILE", "the pictures' light: a Radiance .hdr file, or bright-desert",
                                request.environment),
                    {"help", "", "this text", [&](const std::string&) { request.help = true; }}}});
}

Request parse(int argc, char** argv) {
    Request request;
    request.files = parse_options(argc, argv, options(request));
    if (request.help) return request;
    if (request.files.empty()) throw UsageError("name the pictures to judge, as in build/judge out.ppm");
    require_possible(request.correct);
    if (request.correct.samples > 1000) throw UsageError("--samples: at most 1000 can be judged");
    return request;
}

std::string report(const std::string& file, const PictureFile& picture, const PictureJudgement& judgement) {
    const std::string codes = picture.maxval > 0 ? formatted("codes to %d", picture.maxval) : "linear floats";
    std::string text =
        "# " + file + formatted(": %d x %d pixels, %s\n", picture.image.width(), picture.image.height(), codes.c_str());
    text += "# quantity       measured     expected       spread   accepted from and to\n";
    std::string outside;
    for (const Quantity& q : judgement.comparison.quantities) {
        text += formatted("%-12s %12.5g %12.5g %12.5g %12.5g %12.5g\n", q.name.c_str(), q.here, q.expected, q.spread, q.low,
                     q.high);
        if (!q.fits()) outside += (outside.empty() ? "" : ", ") + q.name;
    }
    const Lag lag = lag_of(judgement.comparison.strangest);
    text += formatted(
        "# The block that errs most is around column %d, row %d; \"repeats\" is of pixels %d columns and %d rows "
        "apart.\n",
        judgement.block.x, judgement.block.y, lag.x, lag.y);
    if (judgement.fits()) return text + "# Verdict: within what correct programs do.\n";
    return text + "# Verdict: not what correct programs do, by " + outside +
           (judgement.mistake.empty() ? "" : "; likely: " + judgement.mistake) + ".\n";
}

Outcome run(Request request) {
    if (request.help)
        return "usage: build/judge FILE... [options]     pictures of one program: PPM or PFM (-: standard input)\n\n" +
               describe(options(request));
    const EnvironmentMap light = load_environment(request.environment);
    Outcome outcome("");
    for (const std::string& file : request.files) {
        std::optional<PictureFile> picture;
        read_input(file, [&](std::istream& in) { picture = read_picture(in); });
        const PictureJudgement judgement = judge_picture(*picture, light, request.correct, terminal_progress("judge"));
        outcome.text += (outcome.text.empty() ? "" : "\n\n") + report(file, *picture, judgement);
        if (!judgement.fits()) outcome.status = 1;
    }
    return outcome;
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("judge", [&] { return run(parse(argc, argv)); });
}
