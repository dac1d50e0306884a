// Of the commands that take many options; belief has its own test.
#include "beyond/request.h"
#include "experiments/error_table.h"
#include "experiments/rule.h"
#include "test.h"

// Of each option values that are not the usual one, but for those that name a file, and threads, which change no byte.
static const std::vector<std::string> other_values = rows_of(
    "--method=single --samples=7 --pool=3 --pool=1 --covariance=squared-exponential --smoothness=1.4 --noise=0.5 "
    "--known=cosine --known=light --placement=fibonacci --seed=65537 --size=9x8 --exposure=-1 --format=pfm "
    "--mc-estimates=7 --bmc-estimates=7 --length-scale=0.3 --matrices --integrand=cosine-cubed --show=error "
    "--rmse=0.1 --threads --environment --directions")[0];

template <class Experiment>
static std::string output_of(const std::vector<std::string>& words, Experiment& experiment) {
    parse(words, experiment.options());
    std::string output;
    stderr_of([&] { output = experiment.report(); });
    return output;
}

// Whether each other value changes the output that these words have, or gets a note that it does not. Options among the
// words do not count, nor do values that are refused beside them.
template <class Experiment>
static void check_options(const std::string& words) {
    const std::vector<std::string> usual = rows_of(words)[0];
    Experiment before;
    const std::string output = output_of(usual, before);
    for (const Option& option : before.options().all) {
        int values = 0;
        for (const std::string& value : other_values) {
            if (value.substr(2, value.find('=') - 2) != option.name) continue;
            ++values;
            if (contains(words, "--" + option.name)) continue;
            std::vector<std::string> with = usual;
            with.push_back(value);
            Experiment experiment;
            bool same = false, noted = false;
            if (!message_of([&] { same = output_of(with, experiment) == output; }).empty()) continue;
            for (const Option& each : experiment.options().all)
                noted = noted || (each.name == option.name && !each.idle_with.empty());
            INFO(words, " ", value);
            CHECK(noted == same);
        }
        CHECK_MESSAGE(values > 0, option.name);
    }
}

TEST_CASE("every option changes what is printed, or a note says that it does not") {
    const TemporaryFile light("#?RADIANCE\n\n-Y 3 +X 2\n" + std::string(8, '\200') + std::string(16, '\177'));
    const TemporaryFile directions("0 1 0\n");
    for (const std::string more :
         {"", "--method=mc", "--method=mc --known=light", "--method=single --format=pfm", "--method=direct --rmse=0.02",
          "--method=direct --covariance=squared-exponential", "--method=single --rmse=0.02"})
        check_options<beyond::Request>("--size=8 --environment=" + light.name + ' ' + more);
    for (const std::string& more :
         {std::string("--seed=2"), std::string("--covariance=squared-exponential"), "--directions=" + directions.name})
        check_options<RuleReport>(more);
    for (const std::string more : {"", "--covariance=squared-exponential"})
        check_options<ErrorTables>("--integrand=cosine --samples=9 --mc-estimates=3 --bmc-estimates=3 " + more);
}
