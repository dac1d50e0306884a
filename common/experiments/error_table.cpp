#include "experiments/error_table.h"

#include <algorithm>
#include <sstream>

#include "quadrature/gaussian_process.h"

namespace bmc {
namespace {

constexpr long max_estimates = 100000;

// A list such as 10,20,40.
std::vector<std::size_t> parse_samples(const std::string& text) {
    std::istringstream words(text + ',');
    std::vector<std::size_t> numbers;
    for (std::string word; std::getline(words, word, ',');) {
        if (word.empty()) throw UsageError("'" + text + "' is no list such as 10,20,40");
        numbers.push_back(static_cast<std::size_t>(parse_integer(word, 1, max_process_samples)));
    }
    return numbers;
}

// Of so many errors; 0 where it is only rounding.
double mean(double sum, std::size_t estimates, const Integrand& integrand) {
    const double error = sum / static_cast<double>(estimates);
    return std::fabs(error) < 1e-12 * std::fabs(integrand.truth) ? 0 : error;
}

// BEGIN SOLUTION table
// The means of |estimate - truth| over so many estimates with n samples, and of the standard errors that Bayesian Monte
// Carlo predicts. Estimate e takes the directions that estimate_directions gives for it.
ErrorRow error_row(const Integrand& integrand, const Covariance& covariance, const ErrorSettings& settings,
                   std::size_t n) {
    ErrorRow row{n, 0, 0, 0};
    for (std::size_t e = 0; e < std::max(settings.mc_estimates, settings.bmc_estimates); ++e) {
        const DirectionSet set = estimate_directions(settings, n, e);
        if (e < settings.mc_estimates)
            row.mc_error += std::fabs(apply(monte_carlo_rule(set), integrand) - integrand.truth);
        if (e >= settings.bmc_estimates) continue;
        const std::vector<double> values = sample(integrand, set.directions, settings.known);
        const GaussianProcess process(covariance, settings.noise, set.directions, settings.known);
        row.bmc_error += std::fabs(process.integral(values) - integrand.truth);
        row.bmc_predicted += process.standard_error(values);
    }
    row.mc_error = mean(row.mc_error, settings.mc_estimates, integrand);
    for (double* sum : {&row.bmc_error, &row.bmc_predicted}) *sum = mean(*sum, settings.bmc_estimates, integrand);
    return row;
}
// END SOLUTION

}  // namespace

std::vector<ErrorRow> error_table(const Integrand& integrand, const ErrorSettings& settings) {
    const std::unique_ptr<Covariance> covariance = settings.make_covariance();
    std::vector<ErrorRow> rows;
    for (const std::size_t n : settings.samples) rows.push_back(error_row(integrand, *covariance, settings, n));
    return rows;
}

std::string error_report(const Integrand& integrand, const std::vector<ErrorRow>& rows) {
    std::string text = "# integral of " + integrand.formula + formatted(" = %.10f\n", integrand.truth) +
                       "# samples     mc_error    bmc_error bmc_predicted        mc/bmc   mc_samples\n";
    for (const ErrorRow& row : rows)
        text += formatted("%9zu %12.5g %12.5g %13.5g %13.5g %12.5g\n", row.samples, row.mc_error, row.bmc_error,
                          row.bmc_predicted, row.gain(), row.equivalent_mc_samples());
    return text;
}

std::vector<Integrand> integrands_named(const std::string& name) {
    std::vector<Integrand> all = practice_integrands();
    if (name.empty()) return all;
    std::string names;
    for (const Integrand& integrand : all) {
        if (integrand.name == name) return {integrand};
        names += (names.empty() ? "" : ", ") + integrand.name;
    }
    throw UsageError("--integrand: '" + name + "' is none of " + names);
}

std::vector<Option> ErrorTables::options() {
    const ModelOptions model(settings);
    return join(
        {{name_option("integrand", "NAME", "constant, cosine, cosine-cubed or environment (default: all)", integrand),
          {"samples", "LIST", "numbers of samples (default 10,20,30,40,50,60,70,80,90,100)",
           [this](const std::string& text) { settings.samples = parse_samples(text); }},
          count_option("mc-estimates", "M", "estimates of MC in a mean error (default 100)", settings.mc_estimates,
                       max_estimates),
          count_option("bmc-estimates", "M", "estimates of BMC in a mean error (default 10)", settings.bmc_estimates,
                       max_estimates)},
         model.process,
         {model.known, model.placement, model.seed}});
}

std::string ErrorTables::report() const {
    require_closed_form(settings);
    std::string text;
    for (const Integrand& each : integrands_named(integrand))
        text += (text.empty() ? "" : "\n\n") + error_report(each, error_table(each, settings));
    return text;
}
}  // namespace bmc
