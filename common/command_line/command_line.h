// What the programs share: options, exit statuses and standard output. A mistake of the caller throws
// std::invalid_argument, which says what was given and what is allowed.
#pragma once

#include "base/formatted.h"
#include "quadrature/model.h"

#include <map>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bmc {
// The whole text as a number. All throw std::invalid_argument unless it lies in [low, high].
double parse_real(const std::string& text, double low, double high);
std::uint64_t parse_integer(const std::string& text, std::uint64_t low, std::uint64_t high);
template <class Number>
Number parse(const std::string& text, Number low, Number high) {
    if constexpr (std::is_integral_v<Number>)
        return static_cast<Number>(parse_integer(text, std::uint64_t(low), std::uint64_t(high)));
    else
        return parse_real(text, low, high);
}

struct Option {
    std::string name;                             // without the dashes
    std::string argument;                         // what stands for its value in the help; empty if it takes none
    std::string description;                      // a line
    std::function<void(const std::string&)> set;  // throws std::invalid_argument
    std::vector<std::pair<std::string, std::function<bool()>>> idle = {};  // "with --method mc", and whether that is so
};

// An option whose values have names; the usual one is its default.
Option choice(const char* name, const std::vector<std::string>& names, std::size_t usual, const char* remark,
              const std::function<void(std::size_t)>& choose);

// The words of a command, and its options in the order of the help. A command adds its options, which set variables of
// its own, and takes them; then it does what they say.
struct Arguments {
    std::vector<std::string> words;  // the first one is the command
    std::string usage;
    std::vector<Option> options = {};

    void add(Option option);

    // Adds an option that sets a text, a switch, a number from low to high, or a value that has a name. The description
    // ends with the default, if that is not empty.
    void add(const char* name, const char* argument, const std::string& description, std::string& text);
    void add(const char* name, const char* description, bool& given);
    template <class Number>
    void add(const char* name, const char* argument, const char* description, Number& number,
             std::common_type_t<Number> low, std::common_type_t<Number> high) {
        add({name, argument, formatted("%s (default %g)", description, static_cast<double>(number)),
             [=, &number](const std::string& text) { number = parse<Number>(text, low, high); }});
    }
    template <class T, std::size_t count>
    void add(const char* name, const char* const (&names)[count], T& value, const char* remark = "") {
        add(choice(name, {names, names + count}, static_cast<std::size_t>(value), remark,
                   [&value](std::size_t chosen) { value = static_cast<T>(chosen); }));
    }

    // The options of these names change nothing "with --method mc", where that holds.
    void make_idle(const std::vector<std::string>& names, const std::string& with, const std::function<bool()>& holds);

    // Applies the options in the words, "--name value", "--name=value" or "--name", and sets `given`, the value of each
    // name. Returns the words that no option takes. Throws std::invalid_argument that names the option.
    std::vector<std::string> read();
    std::map<std::string, std::string> given = {};

    // The same, where no other words are allowed. A note on stderr names each option that changes nothing. file: what
    // the output goes to, if it is no text for a terminal. Throws Help if that is what the words ask for.
    void take(const std::string& file = "");

    // Lines of at most 100 characters for each option.
    std::string describe() const;
};

// Thrown in place of an output.
struct Help {
    std::string text;
};

// Adds the options that both programs take: covariance, smoothness, length-scale, noise, known, placement, seed. A
// program may let more be known than the parts in Known, and then looks for the name in `given`; its rules know the
// cosine.
void add_model_options(Arguments& arguments, ModelSettings& settings,
                       const std::vector<std::string>& known = {std::begin(known_names), std::end(known_names)});

// Adds the option samples, which takes a list such as 10,20,40; each number is at most max_process_samples.
void add_sample_list(Arguments& arguments, std::vector<std::size_t>& samples);

// Prints to stdout what run returns for the words, or the help that it throws, all of it or nothing. Returns the exit
// status: 0, 2 after std::invalid_argument, 1 after any other exception. An exception becomes one line on stderr, which
// begins with the program's name.
int run_program(const char* name, std::string (*run)(const std::vector<std::string>& words),
                const std::vector<std::string>& words);
}  // namespace bmc
