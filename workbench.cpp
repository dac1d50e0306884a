// Prints the error tables of Monte Carlo against Bayesian Monte Carlo, and what its commands report: columns between
// white space under lines that begin with '#', as gnuplot and awk read them.
#include "base/portable_math.h"

#include "experiments/reports.h"

using namespace bmc;

struct Command {
    std::string name;  // empty: what the workbench does without a command
    std::string summary;
    std::string (*report)(Arguments&);
};

static const Command commands[] = {{"", "errors of Monte Carlo and Bayesian MC", error_tables},
                                   {"rule", "directions and weights of a rule", rule_report},
                                   {"belief", "what a Gaussian process believes, > belief.ppm", belief_discs},
                                   {"light", "an environment as a PFM file, > desert.pfm", light_file},
                                   {"tradeoff", "what accuracy costs", tradeoff_report},
                                   {"models", "covariances and noise compared", models_report},
                                   {"stability", "where the arithmetic breaks", stability_report}};

static std::string run(const std::vector<std::string>& words) {
    const std::string name = words.size() > 1 && words[1][0] != '-' ? words[1] : "";
    std::string names, usages;
    for (const Command& command : commands) {
        names += (names.empty() ? "" : ", ") + command.name;
        usages += formatted("       ./workbench %-22s", command.name.c_str()) + command.summary + '\n';
    }
    for (const Command& command : commands) {
        if (command.name != name) continue;
        Arguments arguments{words, "usage: ./workbench " + name + " [options]\n"};
        if (name.empty())
            arguments.usage = "usage: ./workbench [options]\n" + usages +
                              "\nCompares Monte Carlo with Bayesian Monte Carlo on integrals over the hemisphere.\n";
        else
            arguments.words.erase(arguments.words.begin());
        return command.report(arguments);
    }
    throw std::invalid_argument("unknown command '" + name + "'; commands: " + names);
}

int main(int argc, char** argv) { return run_program("workbench", run, {argv, argv + argc}); }
