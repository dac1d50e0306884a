// Prints the error tables of Monte Carlo against Bayesian Monte Carlo, and the reports of its other experiments:
// columns between white space under lines that begin with '#', as gnuplot and awk read them.
#include "numerics/portable_math.h"

#include "command_line.h"
#include "experiments/error_table.h"
#include "experiments/models.h"
#include "experiments/rule.h"
#include "experiments/stability.h"
#include "experiments/tradeoff.h"
#include "light/desert.h"
#include "light/radiance_hdr.h"

#include <algorithm>
#include <memory>

using namespace bmc;

namespace {

struct Command {
    std::string name;     // empty: what the workbench does without a command
    std::string summary;  // for the help text
    std::vector<Option> options;
    std::function<std::string()> report;  // throws UsageError where options do not fit together
};

// The command that runs an Experiment: a type with options(), which set its members, and report().
template <class Experiment>
Command command(const char* name, const char* summary) {
    const auto experiment = std::make_shared<Experiment>();
    return {name, summary, experiment->options(), [experiment] { return experiment->report(); }};
}

// The built-in environment for other programs, as a Radiance picture.
std::string light_file() {
    require_file_output("./workbench light > desert.hdr");
    return to_radiance_hdr(load_environment());
}

std::vector<Command> commands() {
    return {command<ErrorTables>("", "errors of Monte Carlo and Bayesian MC"),
            command<Rule>("rule", "directions and weights of a rule"),
            {"light", "the built-in light, > desert.hdr", {}, light_file},
            command<Tradeoff>("tradeoff", "what accuracy costs"),
            {"models", "covariances and noise compared", {}, models_report},
            {"stability", "where the arithmetic breaks", {}, stability_report}};
}

// Throws UsageError if there is no such command.
Command command_named(const std::string& name) {
    std::string names;
    for (const Command& command : commands()) {
        if (command.name == name && !name.empty()) return command;
        names += (names.empty() ? "" : ", ") + command.name;
    }
    throw UsageError("there is no command '" + name + "'; the commands are " + names);
}

std::string usage(const Command& command) {
    std::string text = "./workbench " + command.name + (command.name.empty() ? "" : " ");
    text += command.options.empty() ? "" : "[options]";
    text.resize(std::max<std::size_t>(text.size() + 1, 35), ' ');
    return text + command.summary + '\n';
}

std::string help_text(const Command& command, const std::vector<Option>& options) {
    if (!command.name.empty()) return "usage: " + usage(command) + '\n' + describe(options);
    std::string text;
    for (const Command& each : commands()) text += (text.empty() ? "usage: " : "       ") + usage(each);
    return text + "\nOptions of the error tables (./workbench COMMAND --help for those of a command):\n" +
           describe(options) +
           "\nexamples: ./workbench --integrand cosine\n"
           "          ./workbench --integrand cosine --samples 20,40,80 --bmc-estimates 100\n"
           "          ./workbench tradeoff --no-times\n";
}

// What to print. Throws UsageError.
std::function<std::string()> parse(int argc, char** argv) {
    const bool named = argc > 1 && argv[1][0] != '-';
    const Command command = named ? command_named(argv[1]) : commands().front();
    bool help = false;
    std::vector<Option> options = command.options;
    options.push_back({"help", "", named ? "this text" : "this text, of a command its options",
                       [&](const std::string&) { help = true; }});
    try {
        const std::vector<std::string> rest = parse_options(argc - named, argv + named, options);
        if (!help && !rest.empty())
            throw UsageError("unexpected argument '" + rest[0] + "'; a command comes first, and options begin with --");
    } catch (const UsageError& error) {
        throw UsageError((named ? command.name + ": " : "") + error.what());
    }
    if (help) return [=] { return help_text(command, options); };
    return command.report;
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("workbench", [&] { return parse(argc, argv)(); });
}
