// Prints the error tables of Monte Carlo against Bayesian Monte Carlo, and what its commands report: columns between
// white space under lines that begin with '#', as gnuplot and awk read them.
#include "numerics/portable_math.h"

#include "experiments/belief.h"
#include "experiments/error_table.h"
#include "experiments/rule.h"
#include "light/radiance_hdr.h"

// The folder common/beyond brings more commands.
#if __has_include("beyond/commands.h")
#include "beyond/commands.h"
#else
namespace bmc::beyond {
inline std::vector<Command> commands() { return {}; }
}  // namespace bmc::beyond
#endif

using namespace bmc;

namespace {

// The built-in environment for other programs, as a Radiance picture.
std::string light_file() {
    require_file_output("./workbench light > desert.hdr");
    return to_radiance_hdr(load_environment());
}

std::vector<Command> commands() {
    return std::vector<Command>{command<ErrorTables>("", "errors of Monte Carlo and Bayesian MC"),
                                command<RuleReport>("rule", "directions and weights of a rule"),
                                command<Belief>("belief", "what a Gaussian process believes, > belief.ppm"),
                                {"light", "the built-in light, > desert.hdr", {}, light_file}} +
           beyond::commands();
}

// Throws UsageError if there is no such command.
Command command_named(const std::string& name) {
    std::string names;
    for (const Command& each : commands()) {
        if (each.name == name) return each;
        if (!each.name.empty()) names += (names.empty() ? "" : ", ") + each.name;
    }
    throw UsageError("there is no command '" + name + "'; type ./workbench --help, or a command: " + names);
}

std::string help_text(const Command& command, const Options& options) {
    std::string text = "usage: ./workbench " + command.name + (command.name.empty() ? "" : " ") + "[options]\n";
    if (command.name.empty())
        for (const Command& each : commands())
            text += formatted("       ./workbench %-22s", each.name.c_str()) + each.summary + '\n';
    return text + '\n' + describe(options);
}

// What to print. Throws UsageError.
std::string run(int argc, char** argv) {
    const bool named = argc > 1 && argv[1][0] != '-';
    const Command command = command_named(named ? argv[1] : "");
    bool help = false;
    Options options = command.options;
    options.push_back({"help", "", "prints this text", [&](const std::string&) { help = true; }});
    const std::vector<std::string> rest = parse_options(argc - named, argv + named, options);
    if (help) return help_text(command, options);
    if (!rest.empty())
        throw UsageError("'" + rest[0] + "' is no option; a command comes first, and options begin with --");
    return command.report();
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("workbench", [&] { return run(argc, argv); });
}
