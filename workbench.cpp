// Prints the error tables of Monte Carlo against Bayesian Monte Carlo, and the reports on cost, models and stability.
#include "common/portable_math.h"

#include "common/command_line.h"
#include "common/reports.h"

#include <cstdio>

namespace {

struct Request {
    ErrorSettings settings;
    ModelOptions model;
    std::string integrand;    // empty: all
    std::string environment;  // empty: the built-in one
    bool timed = true;
    bool help = false;
};

constexpr long max_estimates = 100000;

// A list "10,20,40" or a range "10:100:10".
std::vector<std::size_t> parse_samples(const std::string& text) {
    const auto split = [&](char separator) {
        std::vector<long> numbers;
        for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
            end = text.find(separator, begin);
            numbers.push_back(parse_integer(text.substr(begin, end - begin), 1, max_process_samples));
        }
        return numbers;
    };
    if (text.find(':') == std::string::npos) {
        const std::vector<long> list = split(',');
        return {list.begin(), list.end()};
    }
    const std::vector<long> range = split(':');
    if (range.size() != 3 || range[0] > range[1]) throw UsageError("'" + text + "' is no range FIRST:LAST:STEP");
    std::vector<std::size_t> samples;
    for (long n = range[0]; n <= range[1]; n += range[2]) samples.push_back(static_cast<std::size_t>(n));
    return samples;
}

std::vector<Option> error_options(Request& request) {
    ErrorSettings& settings = request.settings;
    std::vector<Option> options = {
        {"integrand", "NAME", "constant, cosine, cosine-cubed or environment (default: all)",
         [&](const std::string& text) {
             request.integrand = parse_choice<const char*>(text, {{"constant", "constant"},
                                                                  {"cosine", "cosine"},
                                                                  {"cosine-cubed", "cosine-cubed"},
                                                                  {"environment", "environment"}});
         }},
        {"samples", "LIST", "numbers of samples, as 10,20,40 or FIRST:LAST:STEP (default 10:100:10)",
         [&](const std::string& text) { settings.samples = parse_samples(text); }},
        {"mc-estimates", "M", "estimates that an MC error is the mean of (default 100)",
         [&](const std::string& text) {
             settings.mc_estimates = static_cast<std::size_t>(parse_integer(text, 1, max_estimates));
         }},
        {"bmc-estimates", "M", "estimates that a BMC error is the mean of (default 10)",
         [&](const std::string& text) {
             settings.bmc_estimates = static_cast<std::size_t>(parse_integer(text, 1, max_estimates));
         }},
    };
    for (Option& option : request.model.options()) options.push_back(std::move(option));
    return options;
}

std::vector<Option> tradeoff_options(Request& request) {
    return {{"environment", "FILE", "light from a Radiance .hdr file instead of the built-in desert",
             [&](const std::string& text) { request.environment = text; }},
            {"no-times", "", "leave out what is measured and differs from run to run",
             [&](const std::string&) { request.timed = false; }}};
}

std::string help_text(Request& request) {
    return "usage: ./workbench [options]            error tables of Monte Carlo and Bayesian Monte Carlo\n"
           "       ./workbench known                what it is worth to know the cosine\n"
           "       ./workbench tradeoff [options]   what accuracy costs\n"
           "       ./workbench models               which covariance and noise an integrand requires\n"
           "       ./workbench stability            where the arithmetic breaks\n\n"
           "options of the error tables:\n" +
           describe(error_options(request)) + "\noptions of tradeoff:\n" + describe(tradeoff_options(request)) +
           "\n  --help                        this text\n\n"
           "examples: ./workbench --integrand cosine --samples 10:100:5 --bmc-estimates 100\n"
           "          ./workbench tradeoff --no-times\n";
}

std::string error_tables(Request& request) {
    request.settings.placement = request.model.placement;
    request.settings.noise = request.model.noise;
    request.settings.prior = request.model.prior;
    request.settings.seed = request.model.seed;
    const auto covariance = request.model.make_covariance();
    const SquaredExponential rival(request.model.length_scale);
    std::string text;
    for (const Integrand& integrand : practice_integrands())
        if (request.integrand.empty() || request.integrand == integrand.name)
            text += (text.empty() ? "" : "\n\n") +
                    error_report(integrand, error_table(integrand, *covariance, rival, request.settings));
    return text;
}

std::string run(int argc, char** argv) {
    Request request;
    const std::string command = argc > 1 && argv[1][0] != '-' ? argv[1] : "";
    std::vector<Option> options;
    if (command.empty()) options = error_options(request);
    if (command == "tradeoff") options = tradeoff_options(request);
    options.push_back({"help", "", "", [&](const std::string&) { request.help = true; }});
    const int skipped = command.empty() ? 0 : 1;
    const std::vector<std::string> rest = parse_options(argc - skipped, argv + skipped, options);
    if (request.help) return help_text(request);
    if (!rest.empty()) throw UsageError("unexpected argument '" + rest[0] + "'; options begin with --");
    if (command.empty()) return error_tables(request);
    if (command == "tradeoff") return tradeoff_report(load_environment(request.environment), request.timed);
    if (command == "known") return known_report();
    if (command == "models") return models_report();
    if (command == "stability") return stability_report();
    throw UsageError("there is no command '" + command + "'; the commands are known, tradeoff, models and stability");
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("workbench", [&] { return run(argc, argv); });
}
