#include "command_line/command_line.h"

#include "base/progress.h"

#include <fcntl.h>
#include <getopt.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>

namespace bmc {
static void write_all(const std::string& output) {
#ifdef _WIN32
    _setmode(STDOUT_FILENO, _O_BINARY);  // the bytes as they are
#else
    fcntl(STDOUT_FILENO, F_SETFL, fcntl(STDOUT_FILENO, F_GETFL) & ~O_NONBLOCK);  // who reads slowly loses nothing
#endif
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

void add_model_options(Arguments& arguments, ModelSettings& s, bool* light_known) {
    arguments.add("covariance", covariance_names, s.covariance);
    arguments.add("smoothness", "X", "of sobolev, between 1 and 2", s.smoothness, min_smoothness, max_smoothness);
    arguments.add("length-scale", "X", "of the other covariances, from 0.05", s.length_scale, min_length_scale,
                  max_length_scale);
    arguments.add("noise", "X", "standard deviation of sample errors, relative to f's amplitude", s.noise, 0, 1000);
    std::vector<std::string> known{"nothing", "cosine"};
    if (light_known) known.push_back("light");
    arguments.add(choice("known", known, 0,
                         ": known part of the integrand; a cosine placement makes it cosine unless given",
                         [=, &s](std::size_t chosen) {
                             s.knows_cosine = chosen > 0;
                             if (light_known) *light_known = chosen == 2;
                         }));
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

// found: what getopt_long returned. value: what stands after '=', or else the next word.
static void apply(const Option& option, int found, const std::string& value, bool is_next_word) {
    const std::string name = "--" + option.name;
    if (found == '?') throw std::invalid_argument(name + " takes no value");
    const bool is_option = is_next_word && value.compare(0, 2, "--") == 0;
    if (!option.argument.empty() && (found == ':' || value.empty() || is_option))
        throw std::invalid_argument(name + " needs a value; --help shows which");
    try {
        option.set(value);
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(name + ' ' + option.argument + ": " + error.what());
    }
}

std::vector<std::string> Arguments::read() {
    constexpr int first = 256;  // above all letters
    std::vector<::option> table;
    for (const Option& option : options)
        table.push_back({option.name.c_str(), option.argument.empty() ? no_argument : required_argument, nullptr,
                         first + static_cast<int>(table.size())});
    table.push_back({nullptr, 0, nullptr, 0});
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int argc = static_cast<int>(words.size());
    opterr = 0;
    for (int found; (found = getopt_long(argc, argv.data(), ":", table.data(), nullptr)) != -1;) {
        const char* const word = argv[static_cast<std::size_t>(optind - 1)];
        if (found == '?' && optopt < first) {  // a letter, or 0
            const std::string typed = optopt ? std::string{'-', static_cast<char>(optopt)} : word;
            throw std::invalid_argument("there is no option " + typed.substr(0, typed.find('=')) +
                                        ", or more than one that begins so; --help lists them all");
        }
        const Option& chosen = options[static_cast<std::size_t>((found < first ? optopt : found) - first)];
        apply(chosen, found, optarg ? optarg : "", optarg == word);
        given.push_back(chosen.name);
    }
    return {argv.begin() + optind, argv.end() - 1};
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
    if (!file.empty() && isatty(STDOUT_FILENO))
        throw std::invalid_argument("the picture would go to the terminal; add > " + file);
    for (const Option& option : options)
        for (const auto& [with, holds] : option.idle)
            if (std::count(given.begin(), given.end(), option.name) > 0 && holds())
                print_note("note: --" + option.name + " changes nothing " + with);
}

double parse_real(const std::string& text, double low, double high) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (end != text.c_str() && *end == '\0' && value >= low && value <= high) return value;
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

int run_program(const char* name, const std::function<std::string()>& body) {
    program_name = name;
    const auto output = [&] {
        try {
            return body();
        } catch (const Help& help) {
            return help.text;
        }
    };
    try {
        write_all(output());
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
