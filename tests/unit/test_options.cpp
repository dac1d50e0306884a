// Of the commands that take many options; belief has its own test.
#include "beyond/request.h"
#include "experiments/error_table.h"
#include "experiments/rule.h"
#include "test.h"

template <class Experiment>
static std::string output_of(const std::vector<std::string>& words) {
    Experiment experiment;
    parse(words, experiment.options());
    std::string output;
    const std::string printed = stderr_of([&] { output = experiment.report(); });
    return printed + output;
}

// Of each option a value that is not the usual one.
static const std::vector<std::string> other_values = rows_of(
    "--method=single --samples=7 --pool=3 --covariance=squared-exponential --smoothness=1.4 --noise=0.5 "
    "--known=cosine --placement=fibonacci --seed=65537 --size=9x8 --exposure=-1 --format=pfm --mc-estimates=7 "
    "--bmc-estimates=7 --length-scale=0.3 --matrices --integrand=cosine-cubed --show=error --rmse=0.1")[0];

// Whether each option changes what the usual ones print. Threads change no byte.
template <class Experiment>
static void check_options(const std::vector<std::string>& usual, const std::set<std::string>& skipped = {"threads"}) {
    const TemporaryFile directions("0 1 0\n"), light("#?RADIANCE\n\n-Y 1 +X 1\n\200\100\40\200");
    std::vector<std::string> others = other_values;
    others.insert(others.end(), {"--directions=" + directions.name, "--environment=" + light.name});
    const std::string printed = output_of<Experiment>(usual);
    for (const Option& each : Experiment().options().all) {
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
    check_options<PictureRequest>({"--size=8", "--samples=5", "--environment=black-and-white"});
}
TEST_CASE("the options of the error tables change them") {
    check_options<ErrorTables>({"--integrand=cosine", "--samples=10", "--mc-estimates=3", "--bmc-estimates=3"},
                               {"smoothness", "length-scale", "placement", "noise", "known"});
}

// Whether the notes are those of the options that change nothing beside these words. Options among the words do not
// count, nor do those that are refused with them.
template <class Experiment>
static void check_notes(const std::string& words) {
    const std::vector<std::string> usual = rows_of(words)[0];
    const auto bytes = [](const std::vector<std::string>& all, Experiment& experiment) {
        std::string output;
        parse(all, experiment.options());
        stderr_of([&] { output = experiment.report(); });
        return output;
    };
    Experiment before;
    const std::string without = bytes(usual, before);
    std::vector<std::string> others = other_values;
    others.insert(others.end(), {"--known=light", "--pool=1"});
    int tried = 0;
    for (const std::string& other : others) {
        const std::string name = other.substr(2, other.find('=') - 2);
        const auto is_name = [&](const auto& each) { return each.name == name; };
        const std::vector<Option> options = before.options().all;
        if (contains(words, "--" + name) || std::none_of(options.begin(), options.end(), is_name)) continue;
        std::vector<std::string> with = usual;
        with.push_back(other);
        Experiment experiment;
        bool same = false;
        if (!message_of([&] { same = bytes(with, experiment) == without; }).empty()) continue;
        const std::vector<Option> after = experiment.options().all;
        const bool noted = !std::find_if(after.begin(), after.end(), is_name)->idle_with.empty();
        CAPTURE(words);
        CAPTURE(other);
        CHECK(noted == same);
        ++tried;
    }
    CHECK(tried > 3);
}

TEST_CASE("an option gets a note if it changes nothing, and only then") {
    const TemporaryFile light("#?RADIANCE\n\n-Y 3 +X 2\n" + std::string(8, '\200') + std::string(16, '\177'));
    const std::string picture = "--size=8 --environment=" + light.name + ' ',
                      tables = "--integrand=cosine --samples=9 --mc-estimates=3 --bmc-estimates=3 ";
    for (const char* more : {"", "--method=mc", "--method=mc --known=light", "--method=single --format=pfm",
                             "--method=direct --covariance=squared-exponential", "--method=single --rmse=0.02"})
        check_notes<beyond::Request>(picture + more);
    const TemporaryFile directions("0 1 0\n");
    for (const std::string& more :
         {std::string("--seed=2"), std::string("--covariance=squared-exponential"), "--directions=" + directions.name})
        check_notes<RuleReport>(more);
    for (const char* more : {"", "--covariance=squared-exponential"}) check_notes<ErrorTables>(tables + more);
}
