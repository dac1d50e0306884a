#include "command_line/command_line.h"

#include "linear_algebra/cholesky.h"

#include <fcntl.h>
#include <getopt.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <cstdlib>

namespace bmc {
static const char* program = "bmc";  // its name, once run_program has begun

static void write_all(const std::string& output) {
#ifdef _WIN32
    _setmode(STDOUT_FILENO, _O_BINARY);  // the bytes as they are
#endif
    const bool written = std::fwrite(output.data(), 1, output.size(), stdout) == output.size();
    if (!written || std::fclose(stdout) != 0)  // fclose writes what is buffered
        throw std::runtime_error(std::string("cannot write the output: ") + std::strerror(errno));
}

Options joined(std::initializer_list<Options> lists) {
    Options all;
    for (const Options& each : lists) all.insert(all.end(), each.begin(), each.end());
    return all;
}

std::vector<std::string> parse_options(int argc, char** argv, const Options& options) {
    std::vector<option> table;
    for (const Option& each : options)
        table.push_back({each.name.c_str(), each.argument.empty() ? no_argument : required_argument, nullptr,
                         static_cast<int>(table.size())});  // an index, below all letters
    table.push_back({nullptr, 0, nullptr, 0});
    opterr = 0;
    for (int found; (found = getopt_long_only(argc, argv, ":", table.data(), nullptr)) != -1;) {
        const std::string word = argv[optind - 1];
        if (found == ':') throw std::invalid_argument(word + " needs a value; --help shows which");
        if (found == '?') throw std::invalid_argument("there is no option " + word + "; --help lists them all");
        const Option& chosen = options[static_cast<std::size_t>(found)];
        try {
            chosen.set(optarg ? optarg : "");
        } catch (const std::invalid_argument& error) {
            throw std::invalid_argument("--" + chosen.name + ": " + error.what());
        }
    }
    return {argv + (optind < argc ? optind : argc), argv + argc};  // argc may be 0
}

std::string describe(const Options& options) {
    std::string text;
    for (const Option& each : options)
        text += formatted("  %-20s ", ("--" + each.name + ' ' + each.argument).c_str()) + each.description + '\n';
    return text;
}

std::string run_command(Command command, const std::string& usage, int argc, char** argv) {
    bool help = false;
    command.options.push_back({"help", "", "prints this text", [&](const std::string&) { help = true; }});
    const std::vector<std::string> rest = parse_options(argc, argv, command.options);
    if (help) return usage + '\n' + describe(command.options);
    if (!rest.empty()) throw std::invalid_argument("'" + rest[0] + "' is no option; --help shows what can be typed");
    if (!command.file.empty() && isatty(STDOUT_FILENO))
        throw std::invalid_argument(std::string("the picture would go to the terminal; type ./") + program + ' ' +
                                    command.name + (command.name.empty() ? "> " : " > ") + command.file);
    return command.report();
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

void print_note(const std::string& text) { std::fprintf(stderr, "%s: %s\n", program, text.c_str()); }

int run_program(const char* name, const std::function<std::string()>& body) {
    program = name;
    const auto fail = [](const std::string& problem, int status) {
        print_note(problem);
        return status;
    };
    try {
        try {
            write_all(body());
        } catch (const PartialOutput& incomplete) {
            write_all(incomplete.output);
            throw;
        }
        return 0;
    } catch (const std::invalid_argument& error) {
        return fail(error.what(), 2);
    } catch (const NotPositiveDefinite& error) {
        return fail(error.what() + std::string(refusal_advice), 1);
    } catch (const std::bad_alloc&) {
        return fail("there is not enough memory; ask for fewer samples or pixels", 1);
    } catch (const std::exception& error) {
        return fail(error.what(), 1);
    }
}
}  // namespace bmc
