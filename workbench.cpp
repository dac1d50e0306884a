// Prints the error tables of Monte Carlo against Bayesian Monte Carlo.
#include "common/portable_math.h"

#include "common/command_line.h"
#include "common/experiments.h"

#include <cstdio>

namespace {

struct Request {
    ErrorSettings settings;
    ModelOptions model;
    std::string integrand;  // empty: all
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

std::vector<Option> options_of(Request& request) {
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
        {"help", "", "this text", [&](const std::string&) { request.help = true; }}};
    for (Option& option : request.model.options()) options.insert(options.end() - 1, std::move(option));
    return options;
}

template <class... Numbers>
std::string line(const char* format, Numbers... numbers) {
    char text[256];
    std::snprintf(text, sizeof text, format, numbers...);
    return text;
}

std::string error_report(const Integrand& integrand, const std::vector<ErrorRow>& rows) {
    std::string text = "# integral of " + integrand.formula + line(" = %.10f\n", integrand.truth) +
                       "# samples     mc_error    bmc_error bmc_predicted        mc/bmc   mc_samples     se_error\n";
    for (const ErrorRow& row : rows)
        text += line("%9zu %12.5g %12.5g %13.5g %13.5g %12.5g %12.5g\n", row.samples, row.mc_error, row.bmc_error,
                     row.bmc_predicted, row.gain(), row.equivalent_mc_samples(), row.rival_error);
    return text;
}

std::string run(int argc, char** argv) {
    Request request;
    const std::vector<Option> options = options_of(request);
    const std::vector<std::string> rest = parse_options(argc, argv, options);
    if (request.help)
        return "usage: ./workbench [options]\n\nPrints error tables of Monte Carlo against Bayesian Monte Carlo.\n\n" +
               describe(options);
    if (!rest.empty()) throw UsageError("unexpected argument '" + rest[0] + "'; options begin with --");
    request.settings.placement = request.model.placement;
    request.settings.noise = request.model.noise;
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

}  // namespace

int main(int argc, char** argv) {
    return run_program("workbench", [&] { return run(argc, argv); });
}
