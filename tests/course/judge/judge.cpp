// Whether pictures of the sphere scene that other programs made are right: each beside correct ones of other seeds.
#include "judge_picture.h"
#include "light/desert.h"
#include "light/input.h"
#include "picture.h"

using namespace bmc;

namespace {

struct Request {
    std::vector<std::string> files;  // "-": standard input
    std::string environment = built_in_lights[0];
    PictureSettings correct;  // what correct programs would do
    bool help = false;
};

std::vector<Option> options(Request& request) {
    const PictureOptions of_picture(request.correct);
    return join(
        {{of_picture.method, of_picture.samples, of_picture.pool, of_picture.placement},
         of_picture.process,
         {of_picture.known,
          name_option("environment", "FILE", std::string("the pictures' ") + environment_help, request.environment),
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

std::string report(const std::string& file, const Expected& expected, const Judgement& judgement) {
    const PictureSettings& settings = expected.settings;
    std::string text =
        "# " + file + formatted(": %d x %d pixels, ", settings.width, settings.height) +
        (expected.maxval > 0 ? formatted("codes to %d", expected.maxval) : "linear floats") +
        formatted(", beside --method %s --samples %zu\n", name_of(settings.method, method_names), settings.samples) +
        "# quantity       measured     expected   accepted from and to\n";
    std::string outside;
    for (const Quantity& q : judgement.comparison.quantities) {
        text += formatted("%-12s %12.5g %12.5g %12.5g %12.5g\n", q.name.c_str(), q.measured, q.expected, q.low, q.high);
        if (!q.fits()) outside += (outside.empty() ? "" : ", ") + q.name;
    }
    const Lag lag = lag_of(judgement.comparison.most_deviating_lag);
    text +=
        formatted("# The block that errs most is around column %d, row %d; ", judgement.block.x, judgement.block.y) +
        formatted("\"repeats\" is of pixels %d columns and %d rows apart.\n", lag.x, lag.y);
    if (judgement.comparison.fits()) return text + "# Verdict: within what correct programs do.\n";
    return text + "# Verdict: not what correct programs do, by " + outside + (judgement.reason.empty() ? "" : "; ") +
           judgement.reason + ".\n";
}

// Sets the exit status to 1 if a picture is wrong.
std::string run(Request request, int& status) {
    if (request.help)
        return "usage: build/judge FILE... [options]     pictures of one program: PPM or PFM (-: standard input)\n\n" +
               describe(options(request));
    const EnvironmentMap environment = load_environment(request.environment);
    const EnvironmentLight light = prefilter(environment);
    std::optional<Expected> expected;
    std::string text;
    for (const std::string& file : request.files) {
        std::optional<PictureFile> picture;
        read_input(file, [&](std::istream& in) { picture = read_picture(in); });
        if (!expected || !expected->serves(*picture))
            expected = expect(light, request.correct, *picture, terminal_progress("judge"));
        const Judgement judgement = judge(*picture, *expected);
        text += (text.empty() ? "" : "\n\n") + report(file, *expected, judgement);
        if (!judgement.comparison.fits()) status = 1;
    }
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    int status = 0;
    const int failure = run_program("judge", [&] { return run(parse(argc, argv), status); });
    return failure == 0 ? status : failure;
}
