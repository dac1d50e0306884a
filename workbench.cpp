// Prints the error tables of Monte Carlo against Bayesian Monte Carlo, and what its commands report: columns between
// white space under lines that begin with '#', as gnuplot and awk read them.
#include "base/portable_math.h"

#include "experiments/reports.h"

#include <algorithm>

using namespace bmc;

static std::string run(std::vector<std::string> words) {
    const std::vector<Command> commands{{"", "errors of Monte Carlo and Bayesian MC", error_tables},
                                        {"rule", "directions and weights of a rule", rule_report},
                                        {"belief", "what a Gaussian process believes, > belief.ppm", belief_discs},
                                        {"light", "an environment as a PFM file, > desert.pfm", light_file},
                                        {"tradeoff", "what accuracy costs", tradeoff_report},
                                        {"models", "covariances and noise compared", models_report},
                                        {"stability", "where the arithmetic breaks", stability_report}};
    const std::string name = words.size() > 1 && words[1][0] != '-' ? words[1] : "";  // "": no command
    std::string names, usages;
    for (const Command& command : commands) {
        names += (names.empty() ? "" : ", ") + command.name;
        usages += formatted("       ./workbench %-22s", command.name.c_str()) + command.summary + '\n';
    }
    const auto named = std::find_if(commands.begin(), commands.end(), [&](const Command& c) { return c.name == name; });
    if (named == commands.end()) throw std::invalid_argument("unknown command '" + name + "'; commands: " + names);
    std::string usage = "usage: ./workbench [options]\n" + usages +
                        "\nCompares Monte Carlo with Bayesian Monte Carlo on integrals over the hemisphere.\n";
    if (!name.empty()) {
        usage = "usage: ./workbench " + name + " [options]\n";
        words.erase(words.begin());
    }
    Arguments arguments{words, usage};
    return named->report(arguments);
}

int main(int argc, char** argv) {
    return run_program("workbench", [&] { return run({argv, argv + argc}); });
}
