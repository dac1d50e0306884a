// A command of the workbench: one experiment, its options and what it prints. The text has columns between white space
// under lines that begin with '#', so that gnuplot and awk read it as it is, and ends in the sentences that it was made
// for.
#pragma once

#include "numerics/portable_math.h"

#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "options.h"

struct Command {
    std::string name;     // empty: what the workbench does without a command
    std::string summary;  // for the help text
    std::vector<Option> options;
    std::function<Outcome()> report;  // throws UsageError where options do not fit together
};

// The command that runs an Experiment: a type with options(), which set its members, and report().
template <class Experiment>
Command command(const char* name, const char* summary) {
    const auto experiment = std::make_shared<Experiment>();
    return {name, summary, experiment->options(), [experiment] { return experiment->report(); }};
}

// What printf would print; at most 319 characters.
template <class... Arguments>
std::string line(const char* format, Arguments... arguments) {
    char text[320];
    std::snprintf(text, sizeof text, format, arguments...);
    return text;
}
