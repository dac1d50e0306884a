#include "command_line.h"

#include <fcntl.h>
#include <getopt.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>

namespace bmc {
namespace {

void write_all(const std::string& output) {
#ifdef _WIN32
    _setmode(STDOUT_FILENO, _O_BINARY);  // the bytes as they are
#else
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe and a limit on files are then failed writes
    std::signal(SIGXFSZ, SIG_IGN);
#endif
    const bool written = std::fwrite(output.data(), 1, output.size(), stdout) == output.size();
    if (!written || std::fclose(stdout) != 0)  // a short output is written here
        throw std::runtime_error(std::string("cannot write the output: ") + std::strerror(errno));
}

// What getopt_long returns for options[0]; a value for each, or it would take --s for the first that begins so.
constexpr int first_option = 256;

// After getopt_long has returned ':' or '?', with an option, a letter, or 0 for another word in optopt.
UsageError not_found(int reason, char** argv) {
    const std::string word = argv[optind - 1];
    if (reason == ':') return UsageError(word + " needs a value; --help shows which");
    if (optopt >= first_option) return UsageError(word.substr(0, word.find('=')) + " takes no value");
    const std::string name = optopt == 0 ? word : std::string("-") + static_cast<char>(optopt);
    return UsageError("there is no option " + name + "; --help lists them all");
}

// One line, whatever the words and file names in it hold, and not a long one.
void print_error(const char* name, std::string text) {
    if (text.size() > 600) text.replace(200, text.size() - 500, "...");
    for (char& c : text)
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
    std::fprintf(stderr, "%s: %s\n", name, text.c_str());
}

template <class T>
T parse_whole(const std::string& text, T low, T high) {
    T value{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc() && stop == end && low <= value && value <= high) return value;
    throw UsageError("'" + text + "' is not a whole number from " + std::to_string(low) + " to " +
                     std::to_string(high));
}

}  // namespace

std::vector<std::string> parse_options(int argc, char** argv, const std::vector<Option>& options) {
    std::vector<option> table;
    for (const Option& o : options)
        table.push_back({o.name.c_str(), o.argument.empty() ? no_argument : required_argument, nullptr,
                         first_option + static_cast<int>(table.size())});
    table.push_back({nullptr, 0, nullptr, 0});
    opterr = 0;
    std::vector<const Option*> given;
    for (int found; (found = getopt_long(argc, argv, ":", table.data(), nullptr)) != -1;) {
        if (found < first_option) throw not_found(found, argv);
        const Option& chosen = options[static_cast<std::size_t>(found - first_option)];
        given.push_back(&chosen);
        try {
            chosen.set(optarg ? optarg : "");
        } catch (const UsageError& error) {
            throw UsageError("--" + chosen.name + ": " + error.what());
        }
    }
    for (const Option* o : given)
        if (const std::string reason = o->why_useless ? o->why_useless() : ""; !reason.empty())
            throw UsageError("--" + o->name + " would change nothing: " + reason + "; leave it out");
    return {argv + std::min(optind, argc), argv + argc};  // a caller may give no words at all, not even a name
}

std::string describe(const std::vector<Option>& options) {
    constexpr std::size_t indent = 23, width = 80;
    std::string text;
    for (const Option& o : options) {
        std::string line = "  --" + o.name + (o.argument.empty() ? "" : " ") + o.argument;
        line.resize(std::max(line.size() + 1, indent - 1), ' ');
        std::istringstream words(o.description);
        for (std::string word; words >> word; line += ' ' + word)
            if (line.size() + 1 + word.size() > width) {
                text += line + '\n';
                line = std::string(indent - 1, ' ');
            }
        text += line + '\n';
    }
    return text;
}

// strtod alone would also skip white space and read hexadecimal numbers.
double parse_real(const std::string& text, double low, double high) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    const bool decimal = text.find_first_of(" \t\n\v\f\rxX") == std::string::npos && !text.empty();
    if (decimal && end == text.c_str() + text.size() && value >= low && value <= high) return value;
    throw UsageError("'" + text + formatted("' is not a number from %g to %g", low, high));
}

long parse_integer(const std::string& text, long low, long high) { return parse_whole(text, low, high); }

std::uint64_t parse_seed(const std::string& text) { return parse_whole<std::uint64_t>(text, 0, UINT64_MAX); }

Option name_option(const char* name, const char* argument, const std::string& description, std::string& value) {
    return {name, argument, description, [&value](const std::string& text) {
                if (text.empty()) throw UsageError("an empty text is no name");
                value = text;
            }};
}

Option real_option(const char* name, const char* argument, const char* description, double& value,
                   std::pair<double, double> range) {
    return {name, argument, description,
            [&value, range](const std::string& text) { value = parse_real(text, range.first, range.second); }};
}

Option seed_option(const char* description, std::uint64_t& seed) {
    return {"seed", "K", description, [&seed](const std::string& text) { seed = parse_seed(text); }};
}

std::vector<Option> join(const std::vector<std::vector<Option>>& groups) {
    std::vector<Option> options;
    for (const std::vector<Option>& group : groups) options.insert(options.end(), group.begin(), group.end());
    return options;
}

Option useless_while(const std::function<std::string()>& reason, Option option) {
    option.why_useless = [reason, earlier = option.why_useless] {
        const std::string why = reason();
        return why.empty() && earlier ? earlier() : why;
    };
    return option;
}

int run_program(const char* name, const std::function<std::string()>& body) {
    try {
        write_all(body());
        return 0;
    } catch (const UsageError& error) {
        print_error(name, error.what());
        return 2;
    } catch (const std::bad_alloc&) {
        print_error(name, "there is not enough memory; ask for fewer samples or pixels");
    } catch (const std::exception& error) {
        print_error(name, error.what());
    }
    return 1;
}

void require_file_output(const std::string& command) {
    if (isatty(STDOUT_FILENO)) throw UsageError("the picture would go to the terminal; write " + command);
}

std::function<void(double)> terminal_progress(const char* name) {
    if (!isatty(STDERR_FILENO)) return nullptr;
    return [name, shown = 0](double done) mutable {
        const int percent = static_cast<int>(100 * done);
        if (percent == 100)
            std::fprintf(stderr, "%*s\r", static_cast<int>(std::strlen(name)) + 7, "");
        else if (percent > shown)
            std::fprintf(stderr, "%s: %3d %%\r", name, percent);
        shown = percent;
    };
}
}  // namespace bmc
