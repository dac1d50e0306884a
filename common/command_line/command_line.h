// What the programs share: options by getopt_long, exit statuses and standard output. A mistake of the caller is a
// std::invalid_argument: what was given, what is allowed.
#pragma once

#include "numerics/formatted.h"
#include "numerics/portable_math.h"

#include <functional>
#include <initializer_list>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bmc {
// Output that lacks a part. It is printed all the same; the exit status is 1.
struct PartialOutput : std::runtime_error {
    std::string output;
    PartialOutput(std::string printed, const std::string& missing)
        : std::runtime_error(missing), output(std::move(printed)) {}
};

struct Option {
    std::string name;                             // without the dashes
    std::string argument;                         // what stands for its value in the help; empty if it takes none
    std::string description;                      // a line
    std::function<void(const std::string&)> set;  // throws std::invalid_argument
    std::string idle_with = {};                   // "--covariance sobolev", if it changes nothing because of that
};
using Options = std::vector<Option>;

// What a program can be asked for.
struct Experiment {
    virtual ~Experiment() = default;
    virtual Options options() = 0;           // they set members of this object; idle with the values that these have
    virtual std::string report() const = 0;  // the text to print; throws std::invalid_argument if values do not fit
};

struct Command {
    std::string name;  // empty: what the workbench does without a command
    std::string summary;
    std::shared_ptr<Experiment> experiment;
    std::string file = "";  // what its output goes to, if it is no text for a terminal
};

// The options of all these lists.
Options joined(std::initializer_list<Options> lists);

// The options of these names change nothing with another one.
void make_idle(Options& options, std::initializer_list<std::string> names, const std::string& with);

// The names of the options in argv, and the arguments that no option takes.
struct Arguments {
    std::set<std::string> options;
    std::vector<std::string> rest;
};

// Applies the options in argv. Throws std::invalid_argument that names the option.
Arguments parse_options(int argc, char** argv, const Options& options);

// A line for each option, for a help text.
std::string describe(const Options& options);

// What the command prints for the arguments in argv: its report, or with --help the usage and its options. A note on
// stderr names each option that changes nothing. Throws std::invalid_argument if a file would go to a terminal.
std::string run_command(const Command& command, const std::string& usage, int argc, char** argv);

// The whole text as a number. Both throw std::invalid_argument unless it lies in [low, high].
double parse_real(const std::string& text, double low, double high);
std::uint64_t parse_integer(const std::string& text, std::uint64_t low, std::uint64_t high);

// An enumeration stands beside one table of its names, std::pair<const char*, T>[], which options and reports read.

// "mc, direct or pool".
std::string listed(const std::vector<std::string>& names);
template <class T, std::size_t count>
std::string names_of(const std::pair<const char*, T> (&table)[count]) {
    std::vector<std::string> names;
    for (const auto& row : table) names.push_back(row.first);
    return listed(names);
}

// The value with this name. Throws std::invalid_argument with the list of names.
template <class T, std::size_t count>
T value_of(const std::string& wanted, const std::pair<const char*, T> (&table)[count]) {
    for (const auto& [name, value] : table)
        if (wanted == name) return value;
    throw std::invalid_argument("'" + wanted + "' is not " + names_of(table));
}

template <class T, std::size_t count>
const char* name_of(T wanted, const std::pair<const char*, T> (&table)[count]) {
    for (const auto& [name, value] : table)
        if (value == wanted) return name;
    return "?";
}

// Options that set a value: a named one, a text, a real number in [low, high], a whole number in [1, high].
template <class T, std::size_t count>
Option enum_option(const char* name, const std::pair<const char*, T> (&table)[count], T& value,
                   const std::string& remark = "") {
    return {name, "NAME", names_of(table) + " (default " + name_of(value, table) + ")" + remark,
            [&](const std::string& text) { value = value_of(text, table); }};
}
inline Option text_option(const char* name, const char* argument, const std::string& description, std::string& value) {
    return {name, argument, description, [&value](const std::string& text) { value = text; }};
}
inline Option real_option(const char* name, const char* description, double& value, double low, double high) {
    return {name, "X", description, [=, &value](const std::string& text) { value = parse_real(text, low, high); }};
}
template <class T>
Option integer_option(const char* name, const char* argument, const char* description, T& value, std::uint64_t high) {
    return {name, argument, description,
            [&value, high](const std::string& text) { value = static_cast<T>(parse_integer(text, 1, high)); }};
}

// Prints to stdout what body returns, all of it or nothing. Returns the exit status: 0, 2 after std::invalid_argument,
// 1 after any other exception. An exception becomes one line on stderr, which begins with the program's name.
int run_program(const char* name, const std::function<std::string()>& body);

// Prints a line on stderr, which begins with the program's name. Control characters become question marks, and of a
// long text the middle is left out: it may quote options and files.
void print_note(const std::string& text);

// What to say after the message of a NotPositiveDefinite; run_program does.
constexpr const char* refusal_advice = "; take the default covariance and noise, or --noise 0.1";
}  // namespace bmc
