// Prints the error tables of Monte Carlo against Bayesian Monte Carlo, and the reports on cost, models and stability.
#include "numerics/portable_math.h"

#include "command_line.h"
#include "experiments/reports.h"
#include "scene/desert.h"

#include <cstdio>

namespace {

struct Request {
    std::string command;  // empty: the error tables
    ErrorSettings settings;
    ModelOptions model;
    std::unique_ptr<Covariance> covariance;
    std::string integrand;    // empty: all
    std::string environment;  // empty: the built-in one
    std::size_t rule_samples = 40;
    int size = 64;
    bool timed = true;
    bool help = false;
};

constexpr long max_estimates = 100000;
constexpr std::size_t max_rows = 1000;

std::vector<std::size_t> split(const std::string& text, char separator) {
    std::vector<std::size_t> numbers;
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
        end = text.find(separator, begin);
        const std::string word = text.substr(begin, end - begin);
        if (word.empty()) throw UsageError("'" + text + "' is no list as 10,20,40 and no range FIRST:LAST:STEP");
        numbers.push_back(static_cast<std::size_t>(parse_integer(word, 1, max_process_samples)));
    }
    return numbers;
}

// A list "10,20,40" or a range "10:100:10".
std::vector<std::size_t> parse_samples(const std::string& text) {
    if (text.find(':') == std::string::npos) return split(text, ',');
    const std::vector<std::size_t> range = split(text, ':');
    if (range.size() != 3 || range[0] > range[1])
        throw UsageError("'" + text + "' is no range FIRST:LAST:STEP with FIRST <= LAST");
    std::vector<std::size_t> samples;
    for (std::size_t n = range[0]; n <= range[1]; n += range[2]) samples.push_back(n);
    return samples;
}

void set_samples(ErrorSettings& settings, const std::string& text) {
    settings.samples = parse_samples(text);
    if (settings.samples.size() > max_rows)
        throw UsageError(std::to_string(settings.samples.size()) + " numbers are too many, at most " +
                         std::to_string(max_rows) + " are allowed; give a range a larger STEP");
}

std::vector<Option> error_options(Request& request) {
    ErrorSettings& settings = request.settings;
    std::vector<Option> options = {
        {"integrand", "NAME", "constant, cosine, cosine-cubed or environment (default: all)",
         [&](const std::string& text) { request.integrand = parse_name(text); }},
        {"samples", "LIST", "numbers of samples, as 10,20,40 or FIRST:LAST:STEP (default 10:100:10)",
         [&](const std::string& text) { set_samples(settings, text); }},
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

std::vector<Option> rule_options(Request& request) {
    std::vector<Option> options = {
        {"samples", "N", "directions of the rule (default 40)", [&](const std::string& text) {
             request.rule_samples = static_cast<std::size_t>(parse_integer(text, 1, max_process_samples));
         }}};
    for (Option& option : request.model.options()) options.push_back(std::move(option));
    return options;
}

std::vector<Option> tradeoff_options(Request& request) {
    return {{"environment", "FILE", "light from a Radiance .hdr file instead of the built-in desert",
             [&](const std::string& text) { request.environment = parse_name(text); }},
            {"size", "W", "of the pictures, W x W pixels (default 64)",
             [&](const std::string& text) { request.size = static_cast<int>(parse_integer(text, 2, 1024)); }},
            {"no-times", "", "leave out what is measured and differs from run to run",
             [&](const std::string&) { request.timed = false; }}};
}

// The options of the request's command. Throws UsageError if there is no such command.
std::vector<Option> options_of(Request& request) {
    const std::string& command = request.command;
    if (command.empty()) return error_options(request);
    if (command == "rule") return rule_options(request);
    if (command == "tradeoff") return tradeoff_options(request);
    if (command == "known" || command == "models" || command == "stability") return {};
    throw UsageError("there is no command '" + command +
                     "'; the commands are rule, known, tradeoff, models and stability");
}

std::string help_text() {
    Request request;
    return "usage: ./workbench [options]            error tables of Monte Carlo and Bayesian Monte Carlo\n"
           "       ./workbench rule [options]       directions and weights of a rule\n"
           "       ./workbench known                what it is worth to know the cosine\n"
           "       ./workbench tradeoff [options]   what accuracy costs\n"
           "       ./workbench models               which covariance and noise an integrand requires\n"
           "       ./workbench stability            where the arithmetic breaks\n\n"
           "options of the error tables:\n" +
           describe(error_options(request)) +
           "\noptions of rule: those of the error tables from --covariance on, and\n" +
           describe({rule_options(request).front()}) + "\noptions of tradeoff:\n" +
           describe(tradeoff_options(request)) +
           "\n  --help                        this text\n\n"
           "examples: ./workbench --integrand cosine --samples 10:100:5 --bmc-estimates 100\n"
           "          ./workbench tradeoff --no-times\n";
}

// Throws UsageError.
Request parse(int argc, char** argv) {
    Request request;
    if (argc > 1 && argv[1][0] != '-') request.command = argv[1];
    const int skipped = request.command.empty() ? 0 : 1;
    std::vector<Option> options = options_of(request);
    options.push_back({"help", "", "", [&](const std::string&) { request.help = true; }});
    try {
        const std::vector<std::string> rest = parse_options(argc - skipped, argv + skipped, options);
        if (request.help) return request;
        if (!rest.empty())
            throw UsageError("unexpected argument '" + rest[0] + "'; a command comes first, options begin with --");
    } catch (const UsageError& error) {
        throw UsageError((skipped ? request.command + ": " : "") + error.what());
    }
    request.covariance = request.model.make_covariance();
    request.settings.placement = request.model.placement;
    request.settings.noise = request.model.noise;
    request.settings.prior = request.model.prior;
    request.settings.seed = request.model.seed;
    return request;
}

std::string error_tables(const Request& request) {
    const SquaredExponential rival(request.model.length_scale);
    std::string text, names;
    for (const Integrand& integrand : practice_integrands()) {
        names += (names.empty() ? "" : ", ") + integrand.name;
        if (!request.integrand.empty() && request.integrand != integrand.name) continue;
        text += (text.empty() ? "" : "\n\n") +
                error_report(integrand, error_table(integrand, *request.covariance, rival, request.settings));
    }
    if (text.empty()) throw UsageError("--integrand: '" + request.integrand + "' is none of " + names);
    return text;
}

std::string bayesian_rule_report(const Request& request) {
    Random random(request.model.seed, 0);
    return rule_report(bayesian_rule(*request.covariance, request.model.noise,
                                     place_directions(request.model.placement, request.rule_samples, random),
                                     request.model.prior));
}

std::string run(const Request& request) {
    const std::string& command = request.command;
    if (request.help) return help_text();
    if (command == "rule") return bayesian_rule_report(request);
    if (command == "tradeoff")
        return tradeoff_report(load_environment(request.environment), request.size, request.timed);
    if (command == "known") return known_report();
    if (command == "models") return models_report();
    if (command == "stability") return stability_report();
    return error_tables(request);
}

}  // namespace

int main(int argc, char** argv) {
    return run_program("workbench", [&] { return run(parse(argc, argv)); });
}
