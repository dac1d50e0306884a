// Prints the error tables of Monte Carlo against Bayesian Monte Carlo, and what its commands report: columns between
// white space under lines that begin with '#', as gnuplot and awk read them.
#include "base/portable_math.h"

#include "experiments/error_table.h"
#include "experiments/reports.h"

#include <algorithm>

using namespace bmc;

static std::string run(int argc, char** argv) {
    ErrorTables tables;
    RuleReport rule;
    Belief belief;
    LightFile light;
    TradeoffReport tradeoff;
    ModelsReport models;
    StabilityReport stability;
    KnownLightReport known_light;
    const std::vector<Command> commands{
        {"", "errors of Monte Carlo and Bayesian MC", tables},
        {"rule", "directions and weights of a rule", rule},
        {"belief", "what a Gaussian process believes, > belief.ppm", belief, "belief.ppm"},
        {"light", "an environment as a PFM file, > desert.pfm", light, "desert.pfm"},
        {"tradeoff", "what accuracy costs", tradeoff},
        {"models", "covariances and noise compared", models},
        {"stability", "where the arithmetic breaks", stability},
        {"known-light", "what you gain by knowing the light", known_light}};
    const std::string name = argc > 1 && *argv[1] != '-' ? argv[1] : "";  // "": no command
    std::string names, usages;
    for (const Command& command : commands) {
        names += (names.empty() ? "" : ", ") + command.name;
        usages += formatted("       ./workbench %-22s", command.name.c_str()) + command.summary + '\n';
    }
    const auto named = std::find_if(commands.begin(), commands.end(), [&](const Command& c) { return c.name == name; });
    if (named == commands.end()) throw std::invalid_argument("unknown command '" + name + "'; commands: " + names);
    if (!name.empty()) return run_command(*named, "usage: ./workbench " + name + " [options]\n", argc - 1, argv + 1);
    return run_command(*named,
                       "usage: ./workbench [options]\n" + usages +
                           "\nCompares Monte Carlo with Bayesian Monte Carlo on integrals over the hemisphere.\n",
                       argc, argv);
}

int main(int argc, char** argv) {
    return run_program("workbench", [&] { return run(argc, argv); });
}
