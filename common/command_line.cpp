#include "command_line.h"

#include <getopt.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

std::string in_words(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

void write_all(const std::string& output) {
    std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is then a failed write
    const bool written = std::fwrite(output.data(), 1, output.size(), stdout) == output.size();
    if (!written || std::fflush(stdout) != 0 || std::fclose(stdout) != 0)
        throw std::runtime_error(std::string("cannot write the output: ") + std::strerror(errno));
}

}  // namespace

std::vector<std::string> parse_options(int argc, char** argv, const std::vector<Option>& options) {
    std::vector<option> table;
    for (const Option& o : options)
        table.push_back({o.name.c_str(), o.argument.empty() ? no_argument : required_argument, nullptr, 0});
    table.push_back({nullptr, 0, nullptr, 0});
    opterr = 0;
    for (int index = 0;;) {
        const int found = getopt_long(argc, argv, ":", table.data(), &index);
        if (found == -1) break;
        const std::string word = argv[optind - 1];
        if (found == ':') throw UsageError(word + " needs a value; --help shows which");
        if (found == '?') throw UsageError("there is no option " + word + "; --help lists them all");
        const Option& chosen = options[static_cast<std::size_t>(index)];
        try {
            chosen.set(optarg ? optarg : "");
        } catch (const UsageError& error) {
            throw UsageError("--" + chosen.name + ": " + error.what());
        }
    }
    return {argv + optind, argv + argc};
}

std::string describe(const std::vector<Option>& options) {
    std::string text;
    for (const Option& o : options) {
        std::string line = "  --" + o.name + (o.argument.empty() ? "" : " " + o.argument);
        line.resize(std::max<std::size_t>(line.size() + 1, 32), ' ');
        text += line + o.description + '\n';
    }
    return text;
}

double parse_real(const std::string& text, double low, double high) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    if (text.empty() || end != text.c_str() + text.size() || !(value >= low && value <= high))
        throw UsageError("'" + text + "' is not a number from " + in_words(low) + " to " + in_words(high));
    return value;
}

long parse_integer(const std::string& text, long low, long high) {
    char* end = nullptr;
    errno = 0;
    const long value = std::strtol(text.c_str(), &end, 10);
    if (text.empty() || end != text.c_str() + text.size() || errno != 0 || value < low || value > high)
        throw UsageError("'" + text + "' is not a whole number from " + std::to_string(low) + " to " +
                         std::to_string(high));
    return value;
}

std::uint64_t parse_seed(const std::string& text) {
    return static_cast<std::uint64_t>(parse_integer(text, 0, 2147483647));
}

std::vector<Option> ModelOptions::options() {
    return {
        {"covariance", "NAME", "sobolev (default) or squared-exponential",
         [this](const std::string& text) {
             covariance = parse_choice<std::string>(
                 text, {{"sobolev", "sobolev"}, {"squared-exponential", "squared-exponential"}});
         }},
        {"smoothness", "S", "of the Sobolev covariance, between 1 and 2 (default 1.5)",
         [this](const std::string& text) { smoothness = parse_real(text, 1.001, 1.999); }},
        {"length-scale", "L", "of the squared-exponential covariance, from 0.05 (default 1)",
         [this](const std::string& text) { length_scale = parse_real(text, 0.05, 1e6); }},
        {"noise", "X", "standard deviation of the samples' error (default 0.01)",
         [this](const std::string& text) { noise = parse_real(text, 0, 1000); }},
        {"known", "NAME", "part of the integrand: nothing (default) or cosine, for sobolev with smoothness 1.5",
         [this](const std::string& text) {
             prior.known =
                 parse_choice<KnownPart>(text, {{"nothing", KnownPart::nothing}, {"cosine", KnownPart::cosine}});
         }},
        {"mean", "NAME", "of the prior: zero (default) or uniform, a uniform light of unknown radiance",
         [this](const std::string& text) {
             prior.mean = parse_choice<PriorMean>(text, {{"zero", PriorMean::zero}, {"uniform", PriorMean::uniform}});
         }},
        {"placement", "NAME", "of the directions: uniform (default), fibonacci, cosine or cosine-fibonacci",
         [this](const std::string& text) {
             placement = parse_choice<Placement>(text, {{"uniform", Placement::uniform},
                                                        {"fibonacci", Placement::fibonacci},
                                                        {"cosine", Placement::cosine},
                                                        {"cosine-fibonacci", Placement::cosine_fibonacci}});
         }},
        {"seed", "K", "of the random numbers (default 1)",
         [this](const std::string& text) { seed = parse_seed(text); }}};
}

std::unique_ptr<Covariance> ModelOptions::make_covariance() const {
    if (prior.known == KnownPart::cosine && !(covariance == "sobolev" && smoothness == 1.5))
        throw UsageError(
            "--known cosine goes with --covariance sobolev --smoothness 1.5 only: no other has a closed form");
    if (covariance == "sobolev") return std::make_unique<Sobolev>(smoothness);
    return std::make_unique<SquaredExponential>(length_scale);
}

int run_program(const char* name, const std::function<std::string()>& body) {
    try {
        portable::check_arithmetic();
        write_all(body());
        return 0;
    } catch (const UsageError& error) {
        std::fprintf(stderr, "%s: %s\n", name, error.what());
        return 2;
    } catch (const std::bad_alloc&) {
        std::fprintf(stderr, "%s: there is not enough memory; ask for fewer samples or pixels\n", name);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", name, error.what());
    }
    return 1;
}

std::function<void(double)> terminal_progress(const char* name) {
    if (!isatty(STDERR_FILENO)) return nullptr;
    using Clock = std::chrono::steady_clock;
    return [name, start = Clock::now(), shown = Clock::now()](double done) mutable {
        const Clock::time_point now = Clock::now();
        const std::chrono::duration<double> elapsed = now - start, since_shown = now - shown;
        if (done < 1 && since_shown.count() < 0.2) return;
        shown = now;
        if (done < 1)
            std::fprintf(stderr, "\r%s: %3.0f %%, %.0f s left ", name, 100 * done, elapsed.count() * (1 - done) / done);
        else
            std::fprintf(stderr, "\r%*s\r", static_cast<int>(std::strlen(name)) + 24, "");
    };
}
