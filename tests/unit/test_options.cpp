#include "beyond/known_light_cost.h"
#include "beyond/request.h"
#include "experiments/error_table.h"
#include "experiments/reports.h"
#include "test.h"

#include <map>

using Strings = std::vector<std::string>;
template <class T>
static std::shared_ptr<Experiment> made() {
    return std::make_shared<T>();
}

// A command, words that make it quick, and the options that are tried beside these words: all, those of these names, or
// with this value alone.
struct Trial {
    const char* name;
    std::shared_ptr<Experiment> (*command)();
    std::string words, options;
};
static std::vector<Trial> trials() {
    const std::string light = "--environment=tests/output/bright.hdr", mc = "--size=8 --method=mc " + light;
    const std::string few = "--integrand=cosine --samples=9 --mc-estimates=3 --bmc-estimates=3";
    const std::string squared = " --covariance=squared-exponential";
    return {
        {"renderer", made<beyond::Request>, "--size=8 " + light, ""},
        {"renderer", made<beyond::Request>, "--samples=1 --method=mc", "size environment"},
        {"renderer", made<beyond::Request>, mc, "samples covariance smoothness length-scale noise pool placement seed"},
        {"renderer", made<beyond::Request>, mc + " --known=light", "samples covariance smoothness pool placement"},
        {"renderer", made<beyond::Request>, "--size=8 --method=single --format=pfm " + light, "exposure pool"},
        {"renderer", made<beyond::Request>, "--size=8 --method=direct " + light + squared,
         "smoothness length-scale pool"},
        {"workbench", made<ErrorTables>, few, ""},
        {"workbench", made<ErrorTables>, "--samples=2 --mc-estimates=1 --bmc-estimates=1", "integrand"},
        {"workbench", made<ErrorTables>, few + squared, "length-scale"},
        {"workbench rule", made<RuleReport>, "", ""},
        {"workbench rule", made<RuleReport>, squared, "smoothness length-scale"},
        {"workbench rule", made<RuleReport>, "--directions=tests/output/directions.txt", "samples placement seed"},
        {"workbench belief", made<Belief>, "--samples=1",
         "samples environment covariance smoothness noise known placement=fibonacci seed"},
        {"workbench belief", made<Belief>, "--samples=1" + squared, "length-scale"},
        {"workbench light", made<LightFile>, "", ""},
        {"workbench tradeoff", made<TradeoffReport>, "--no-times --size=4 --samples=3 " + light, ""},
        {"workbench stability", made<StabilityReport>, "--samples=3", ""},
        {"workbench models", made<ModelsReport>, "--samples=3 " + light, ""},
        {"workbench known-light", made<beyond::KnownLightReport>, "--no-times --size=4 --samples=3 " + light, ""}};
}

// The words that are tried of an option, --name=value: each name of the help but the default, or another number.
static Strings words_of(const Option& option) {
    const std::string others =
        "samples=2 pool=3 smoothness=1.4 length-scale=0.3 noise=0.5 seed=65537 size=9 exposure=-1 threads=2 "
        "mc-estimates=7 bmc-estimates=7 environment=black-and-white directions=tests/output/directions.txt";
    if (option.argument.empty()) return {"--" + option.name};
    for (const std::string& other : words_in(others))
        if (other.substr(0, other.find('=')) == option.name) return {"--" + other};
    CHECK(option.argument == "NAME");
    std::string names = option.description.substr(0, option.description.find(" (default "));
    std::replace(names.begin(), names.end(), ',', ' ');
    Strings words;
    for (const std::string& name : words_in(names))
        if (name != "or" && !contains(option.description, "(default " + name + ")"))
            words.push_back("--" + option.name + '=' + name);
    return words;
}

static bool has(const std::string& words, const std::string& word) {
    return contains(' ' + words + ' ', ' ' + word + ' ');
}

// What the command prints, but for comments, and its notes but for those of options that change nothing, whose names go
// to idle.
static std::string printed(const Trial& trial, const std::string& word, Strings& idle) {
    Strings arguments = words_in(trial.words + ' ' + word);
    std::vector<char*> argv = argv_of(arguments);
    const std::shared_ptr<Experiment> experiment = trial.command();
    const Command command{"", "", *experiment};
    std::string text, line, kept;
    std::istringstream notes(
        stderr_of([&] { text = run_command(command, "", static_cast<int>(arguments.size()), argv.data()); }));
    for (std::istringstream lines(text); std::getline(lines, line);)
        if (line[0] != '#') kept += line + '\n';
    while (std::getline(notes, line)) {
        const std::size_t name = line.find("--") + 2, end = line.find(" changes nothing with");
        if (end == line.npos)
            kept += line + '\n';
        else
            idle.push_back(line.substr(name, end - name));
    }
    return kept;
}

TEST_CASE("every option of every command changes what is printed, or says that it does not") {
    std::set<std::string> all, counting;
    for (const Trial& trial : trials()) {
        Strings idle;
        std::map<std::string, std::string> met{{printed(trial, "", idle), "no option"}};
        const std::shared_ptr<Experiment> experiment = trial.command();
        for (const Option& option : experiment->options().all) {
            if (option.name == "no-times") continue;  // it is in the words; times_are_told holds it
            const std::string name = trial.name + (" --" + option.name);
            const bool counts = !contains(option.description, "does not change");
            if (counts) all.insert(name);
            for (const std::string& word : words_of(option)) {
                const bool wanted = trial.options.empty() || has(trial.options, option.name);
                if (has(trial.words, word) || !(wanted || has(trial.options, word.substr(2)))) continue;
                INFO(name, ": ", trial.words, " ", word);
                std::string text;
                idle.clear();
                const std::string mistake = message_of([&] { text = printed(trial, word, idle); });
                CHECK(mistake.substr(0, 2) == (mistake.empty() ? "" : "--"));
                if (!mistake.empty()) continue;
                const bool changes = counts && std::find(idle.begin(), idle.end(), option.name) == idle.end();
                CHECK(met[text] == std::string(changes ? "" : "no option"));
                if (met[text].empty()) met[text] = word, counting.insert(name);
            }
        }
    }
    CHECK(counting == all);
}
