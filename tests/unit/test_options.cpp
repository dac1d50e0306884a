// Of the commands that take many options; belief has its own test.
#include "experiments/error_table.h"
#include "experiments/rule.h"
#include "test.h"

struct PictureCommand : PictureRequest {
    std::string report() const { return file(image(load_environment(environment))); }
};

template <class Experiment>
static std::string output_of(const std::vector<std::string>& words) {
    Experiment experiment;
    parse(words, experiment.options());
    std::string output;
    const std::string printed = stderr_of([&] { output = experiment.report(); });
    return printed + output;
}

// Whether each option changes what the usual ones print. Threads change no byte.
template <class Experiment>
static void check_options(const std::vector<std::string>& usual, const std::set<std::string>& skipped = {"threads"}) {
    const TemporaryFile directions("0 1 0\n"), light("#?RADIANCE\n\n-Y 1 +X 1\n\200\100\40\200");
    std::vector<std::string> others = rows_of(
        "--method=single --samples=7 --pool=3 --covariance=squared-exponential --smoothness=1.4 --noise=0.5 "
        "--known=cosine --placement=fibonacci --seed=65537 --size=9x8 --exposure=-1 --format=pfm --mc-estimates=7 "
        "--bmc-estimates=7 --length-scale=0.3 --matrices --integrand=cosine-cubed")[0];
    others.insert(others.end(), {"--directions=" + directions.name, "--environment=" + light.name});
    const std::string printed = output_of<Experiment>(usual);
    for (const Option& each : Experiment().options()) {
        if (skipped.count(each.name)) continue;
        CAPTURE(each.name);
        std::vector<std::string> words = usual;
        const bool smooth = each.name == "length-scale";
        if (smooth) words.push_back("--covariance=squared-exponential");
        const std::string before = smooth ? output_of<Experiment>(words) : printed;
        for (const std::string& other : others)
            if (other.compare(2, each.name.size(), each.name) == 0) words.push_back(other);
        const bool changes = output_of<Experiment>(words) != before;
        CHECK(changes);
    }
}

TEST_CASE("every option of a rule changes it") { check_options<RuleReport>({"--samples=5"}); }
TEST_CASE("every option of a picture changes it") {
    check_options<PictureCommand>({"--size=8", "--samples=5", "--environment=black-and-white"});
}
TEST_CASE("the options of the error tables change them") {
    check_options<ErrorTables>({"--integrand=cosine", "--samples=10", "--mc-estimates=3", "--bmc-estimates=3"},
                               {"smoothness", "length-scale", "placement", "noise", "known"});
}
