// What the programs share: options on getopt_long, errors, exit statuses and standard output.
#pragma once

#include "numerics/formatted.h"
#include "numerics/portable_math.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bmc {
// A mistake of the caller: what was given, what is allowed. Exit status 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Output in which something is missing. It is printed all the same; exit status 1.
struct Incomplete : std::runtime_error {
    std::string output;

    Incomplete(std::string printed, const std::string& missing)
        : std::runtime_error(missing), output(std::move(printed)) {}
};

struct Option {
    std::string name;                             // without the dashes
    std::string argument;                         // what stands for its value in the help; empty if it takes none
    std::string description;                      // a line
    std::function<void(const std::string&)> set;  // throws UsageError if the value is not allowed
};
using Options = std::vector<Option>;

// A command of the workbench. The program's options set what report returns, the text to print.
struct Command {
    std::string name;  // empty: what the workbench does without a command
    std::string summary;
    Options options;
    std::function<std::string()> report;  // throws UsageError if options do not fit together
};

// The command that runs an Experiment: a type with options(), which set its members, and report().
template <class Experiment>
Command command(const char* name, const char* summary) {
    const auto experiment = std::make_shared<Experiment>();
    return {name, summary, experiment->options(), [experiment] { return experiment->report(); }};
}

// The elements of both lists.
template <class T>
std::vector<T> operator+(std::vector<T> a, const std::vector<T>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

// Applies the options in argv, and returns the arguments that no option takes. Throws UsageError that names the option.
std::vector<std::string> parse_options(int argc, char** argv, const Options& options);

// A line for each option, for a help text.
std::string describe(const Options& options);

// The number that the whole text is. Both throw UsageError unless it lies in [low, high].
double parse_real(const std::string& text, double low, double high);
std::uint64_t parse_whole(const std::string& text, std::uint64_t low, std::uint64_t high);

// An enumeration stands beside one table of its names, std::pair<const char*, T>[], which options and reports read.

// "mc, direct or pool".
template <class T, std::size_t count>
std::string names_of(const std::pair<const char*, T> (&table)[count]) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
        text += (i == 0 ? "" : i + 1 < count ? ", " : " or ") + std::string(table[i].first);
    return text;
}

// The value with this name. Throws UsageError with the list of names.
template <class T, std::size_t count>
T value_of(const std::string& wanted, const std::pair<const char*, T> (&table)[count]) {
    for (const auto& [name, value] : table)
        if (wanted == name) return value;
    throw UsageError("'" + wanted + "' is not " + names_of(table));
}

template <class T, std::size_t count>
const char* name_of(T wanted, const std::pair<const char*, T> (&table)[count]) {
    for (const auto& [name, value] : table)
        if (value == wanted) return name;
    return "?";
}

// Options that set a value: to one with a name, to a text, to a number in [low, high], to a whole number in [1, high].
template <class T, std::size_t count>
Option choice_option(const char* name, const std::pair<const char*, T> (&table)[count], T& value,
                     const std::string& remark = "") {
    return {name, "NAME", names_of(table) + " (default " + name_of(value, table) + ")" + remark,
            [&](const std::string& text) { value = value_of(text, table); }};
}
Option text_option(const char* name, const char* argument, const std::string& description, std::string& value);
Option real_option(const char* name, const char* description, double& value, double low, double high);
template <class T>
Option whole_option(const char* name, const char* argument, const char* description, T& value, std::uint64_t high) {
    return {name, argument, description,
            [&value, high](const std::string& text) { value = static_cast<T>(parse_whole(text, 1, high)); }};
}

// Prints to stdout what body returns, all of it or nothing. Returns the exit status: 0, 2 after a UsageError, 1 after
// any other exception. An exception becomes one line on stderr, which begins with the program's name.
int run_program(const char* name, const std::function<std::string()>& body);

// Throws UsageError if stdout is a terminal, which takes no picture. command is what to type instead.
void require_file_output(const std::string& command);
}  // namespace bmc
