#include "command_line/command_line.h"

#include "base/terminal.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>

namespace bmc {
static void write_all(const std::string& output) {
    const bool written = std::fwrite(output.data(), 1, output.size(), stdout) == output.size();
    if (!written || std::fclose(stdout) != 0)  // fclose writes what is buffered
        throw std::runtime_error(std::string("cannot write the output: ") + std::strerror(errno));
}

void Arguments::add(Option option) { options.push_back(std::move(option)); }

void Arguments::add(const char* name, const char* argument, const std::string& description, std::string& text) {
    add({name, argument, description + (text.empty() ? "" : " (default " + text + ")"),
         [&text](const std::string& value) { text = value; }});
}

void Arguments::add(const char* name, const char* description, bool& is_set) {
    add({name, "", description, [&is_set](const std::string&) { is_set = true; }});
}

void Arguments::make_idle(const std::vector<std::string>& names, const std::string& with,
                          const std::function<bool()>& holds) {
    for (Option& option : options)
        if (std::count(names.begin(), names.end(), option.name) > 0) option.idle.emplace_back(with, holds);
}

Option choice(const char* name, const std::vector<std::string>& names, std::size_t usual, const char* remark,
              const std::function<void(std::size_t)>& choose) {
    return {name, "NAME", listed(names) + " (default " + names[usual] + ")" + remark, [=](const std::string& text) {
                const auto found = std::find(names.begin(), names.end(), text);
                if (found == names.end()) throw std::invalid_argument("'" + text + "' is not " + listed(names));
                choose(static_cast<std::size_t>(found - names.begin()));
            }};
}

void add_model_options(Arguments& arguments, ModelSettings& s, const std::vector<std::string>& known) {
    arguments.add("covariance", covariance_names, s.covariance);
    arguments.add("smoothness", "X", "of sobolev, between 1 and 2", s.smoothness, min_smoothness, max_smoothness);
    arguments.add("length-scale", "X", "of the other covariances, from 0.05", s.length_scale, min_length_scale,
                  max_length_scale);
    arguments.add("noise", "X", "standard deviation of sample errors, relative to f's amplitude", s.noise, 0, 1000);
    arguments.add(choice("known", known, 0,
                         ": known part of the integrand; a cosine placement makes it cosine unless given",
                         [&s](std::size_t chosen) { s.known = chosen == 0 ? Known::nothing : Known::cosine; }));
    std::vector<std::string> placements;
    for (const Placement placement : all_placements()) placements.push_back(placement.name());
    arguments.add(
        choice("placement", placements, 0, "", [&s](std::size_t chosen) { s.placement = all_placements()[chosen]; }));
    arguments.add("seed", "K", "seed of the random numbers", s.seed, 0, UINT64_MAX);
    const auto is_sobolev = [&s] { return s.covariance == CovarianceFamily::sobolev; };
    arguments.make_idle({"length-scale"}, "with --covariance sobolev", is_sobolev);
    arguments.make_idle({"smoothness"}, "without --covariance sobolev", [=] { return !is_sobolev(); });
}

void add_sample_list(Arguments& arguments, std::vector<std::size_t>& samples) {
    std::string usual;
    for (const std::size_t n : samples) usual += (usual.empty() ? "" : ",") + std::to_string(n);
    arguments.add(
        {"samples", "LIST", "numbers of samples (default " + usual + ")", [&samples](const std::string& text) {
             samples.clear();
             for (std::size_t begin = 0, end = 0; end < text.size(); begin = end + 1) {
                 end = std::min(text.find(',', begin), text.size());
                 samples.push_back(parse(text.substr(begin, end - begin), std::size_t{1}, max_process_samples));
             }
         }});
}

std::vector<std::string> Arguments::read() {
    std::vector<std::string> others;
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (word[0] != '-') {
            others.push_back(word);
            continue;
        }
        const std::string name = word.substr(0, word.find('='));
        const auto option =
            std::find_if(options.begin(), options.end(), [&](const Option& each) { return "--" + each.name == name; });
        if (option == options.end())
            throw std::invalid_argument("there is no option " + name + "; --help lists them all");
        const bool takes_value = !option->argument.empty(), joined = name.size() < word.size();
        if (joined && !takes_value) throw std::invalid_argument(name + " takes no value");
        std::string value = joined ? word.substr(name.size() + 1) : "";
        if (takes_value && !joined && i + 1 < words.size() && words[i + 1].compare(0, 2, "--") != 0) value = words[++i];
        if (takes_value && value.empty()) throw std::invalid_argument(name + " needs a value; --help shows which");
        try {
            option->set(value);
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument(name + ' ' + option->argument + ": " + error.what());
        }
        given[option->name] = value;
    }
    return others;
}

std::string Arguments::describe() const {
    std::string text;
    for (const Option& option : options) {
        const std::string begin = "--" + option.name + ' ' + option.argument;
        std::string line = formatted("  %-20s ", begin.c_str()) + option.description;
        for (std::size_t blank; line.size() > 100; line = std::string(23, ' ') + line.substr(blank + 1)) {
            blank = line.rfind(' ', 100);
            text += line.substr(0, blank) + '\n';
        }
        text += line + '\n';
    }
    return text;
}

void Arguments::take(const std::string& file) {
    bool help = false;
    add("help", "print this text", help);
    const std::vector<std::string> others = read();
    if (help) throw Help{usage + '\n' + describe()};
    if (!others.empty())
        throw std::invalid_argument("unexpected argument '" + others[0] +
                                    "'; a command stands before all options; try --help");
    if (!file.empty() && output_is_terminal())
        throw std::invalid_argument("the picture would go to the terminal; add > " + file);
    for (const Option& option : options)
        for (const auto& [with, holds] : option.idle)
            if (given.count(option.name) > 0 && holds())
                print_note("note: --" + option.name + " changes nothing " + with);
}

double parse_real(const std::string& text, double low, double high) {
    char* end = nullptr;
    errno = 0;  // becomes ERANGE where a number is taken for 0, or loses digits
    const double value = std::strtod(text.c_str(), &end);
    if (end != text.c_str() && *end == '\0' && value >= low && value <= high && errno == 0) return value;
    throw std::invalid_argument("'" + text + formatted("' is not a number from %g to %g", low, high));
}

std::uint64_t parse_integer(const std::string& text, std::uint64_t low, std::uint64_t high) {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc() && stop == end && low <= value && value <= high) return value;
    throw std::invalid_argument("'" + text + "' is not a whole number from " + std::to_string(low) + " to " +
                                std::to_string(high));
}

int run_program(const char* name, std::string (*run)(const std::vector<std::string>& words),
                const std::vector<std::string>& words) {
    program_name = name;
    keep_all_bytes();
    try {
        std::string output;
        try {
            output = run(words);
        } catch (const Help& help) {
            output = help.text;
        }
        write_all(output);
        return 0;
    } catch (const std::invalid_argument& error) {
        print_note(error.what());
        return 2;
    } catch (const std::bad_alloc&) {
        print_note("there is not enough memory; ask for fewer samples or pixels");
    } catch (const std::exception& error) {
        print_note(error.what());
    }
    return 1;
}
}  // namespace bmc
