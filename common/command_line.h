// What the programs share: options on getopt_long, errors, exit statuses and standard output.
#pragma once

#include "numerics/formatted.h"
#include "numerics/portable_math.h"

#include <cstdint>
#include <cstdio>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace bmc {
// A mistake of the caller's: what was given, what is allowed. Exit status 2.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Option {
    std::string name;      // without the dashes
    std::string argument;  // what stands for its value in the help; empty: it takes none
    std::string description;
    std::function<void(const std::string&)> set;  // throws UsageError if the value is not allowed

    // Called when all options are read: why the option would change nothing, or an empty text.
    std::function<std::string()> why_useless = nullptr;
};

// Applies the options in argv. Returns the arguments that no option takes. Throws UsageError that names the option,
// also for one that would change nothing.
std::vector<std::string> parse_options(int argc, char** argv, const std::vector<Option>& options);

// For a help text.
std::string describe(const std::vector<Option>& options);

// The number that the whole text is. Throws UsageError unless it lies in [low, high].
double parse_real(const std::string& text, double low, double high);
long parse_integer(const std::string& text, long low, long high);
std::uint64_t parse_seed(const std::string& text);

// An enum stands beside one table of its names, std::pair<const char*, T>; options, help and reports read it.

// The value that the text names; throws UsageError with the list of names.
template <class T, std::size_t count>
T parse_choice(const std::string& text, const std::pair<const char*, T> (&table)[count]) {
    std::string names;
    for (const auto& [name, value] : table) {
        if (text == name) return value;
        names += names.empty() ? name : std::string(", ") + name;
    }
    throw UsageError("'" + text + "' is none of " + names);
}

template <class T, std::size_t count>
const char* name_of(T wanted, const std::pair<const char*, T> (&table)[count]) {
    for (const auto& [name, value] : table)
        if (value == wanted) return name;
    return "";
}

// "mc, direct or pool (default)", for a help text.
template <class T, std::size_t count>
std::string choices(const std::pair<const char*, T> (&table)[count], T standard) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        if (i > 0) text += i + 1 < count ? ", " : " or ";
        text += std::string(table[i].first) + (table[i].second == standard ? " (default)" : "");
    }
    return text;
}

// Options that set a value: by its name in a table, a text that is not empty, a number, a whole number, a seed.
template <class T, std::size_t count>
Option choice_option(const char* name, const std::string& description, const std::pair<const char*, T> (&table)[count],
                     T& value, const char* remark = "") {
    return {name, "NAME", description + choices(table, value) + remark,
            [&](const std::string& text) { value = parse_choice(text, table); }};
}
Option name_option(const char* name, const char* argument, const std::string& description, std::string& value);
Option real_option(const char* name, const char* argument, const char* description, double& value,
                   std::pair<double, double> range);
Option seed_option(const char* description, std::uint64_t& seed);
template <class T>
Option count_option(const char* name, const char* argument, const char* description, T& value, long high,
                    long low = 1) {
    return {name, argument, description,
            [&value, low, high](const std::string& text) { value = static_cast<T>(parse_integer(text, low, high)); }};
}

// The options of all groups.
std::vector<Option> join(const std::vector<std::vector<Option>>& groups);

// The option, which would change nothing while there is a reason.
Option useless_while(const std::function<std::string()>& reason, Option option);

// Prints to stdout what body returns, all of it or nothing. Returns the exit status: 0, 2 after a UsageError, 1 after
// any other exception. It tells of either in one line on stderr that begins with the program's name.
int run_program(const char* name, const std::function<std::string()>& body);

// Throws UsageError if stdout is a terminal, which takes no picture; command is what to write instead.
void require_file_output(const std::string& command);

// Shows on stderr how much of the work is done, if stderr is a terminal.
std::function<void(double)> terminal_progress(const char* name);
}  // namespace bmc
