// Prints the error tables of Monte Carlo against Bayesian Monte Carlo, and what its commands report: columns between
// white space under lines that begin with '#', as gnuplot and awk read them.
#include "numerics/portable_math.h"

#include "experiments/belief.h"
#include "experiments/error_table.h"
#include "experiments/models.h"
#include "experiments/rule.h"
#include "experiments/stability.h"
#include "experiments/tradeoff.h"
#include "light/load_environment.h"

// The folder common/beyond brings more commands.
#if __has_include("beyond/commands.h")
#include "beyond/commands.h"
#else
namespace bmc::beyond {
inline std::vector<Command> commands() { return {}; }
}  // namespace bmc::beyond
#endif

using namespace bmc;

// The built-in environment for other programs: its texels, row 0 at the top, as a PFM.
static std::string light_file() {
    const EnvironmentMap map = load_environment();
    Image image(map.width(), map.height());
    for (int y = 0; y < map.height(); ++y)
        for (int x = 0; x < map.width(); ++x) image(x, y) = map.color(map.index(x, y));
    return encode(image, Format::pfm);
}

static std::string run(int argc, char** argv) {
    std::vector<Command> commands{
        command<ErrorTables>("", "errors of Monte Carlo and Bayesian MC"),
        command<RuleReport>("rule", "directions and weights of a rule"),
        command<Belief>("belief", "what a Gaussian process believes, > belief.ppm", "belief.ppm"),
        {"light", "the built-in light for others, > desert.pfm", {}, light_file, "desert.pfm"},
        command<TradeoffReport>("tradeoff", "what accuracy costs"),
        command<ModelsReport>("models", "covariances and noise compared"),
        {"stability", "where the arithmetic breaks", {}, stability_report}};
    for (const Command& each : beyond::commands()) commands.push_back(each);
    const bool named = argc > 1 && *argv[1] && *argv[1] != '-';
    const std::string name = named ? argv[1] : "";
    std::string names, usages;
    for (const Command& each : commands) {
        if (named && each.name == name)
            return run_command(each, "usage: ./workbench " + name + " [options]\n", argc - 1, argv + 1);
        names += (names.empty() ? "" : ", ") + each.name;
        usages += formatted("       ./workbench %-22s", each.name.c_str()) + each.summary + '\n';
    }
    if (named)
        throw std::invalid_argument("there is no command '" + name +
                                    "'; type ./workbench --help, or a command: " + names);
    return run_command(commands[0], "usage: ./workbench [options]\n" + usages, argc, argv);
}

int main(int argc, char** argv) {
    return run_program("workbench", [&] { return run(argc, argv); });
}
