#include "experiments/error_table.h"

#include "base/progress.h"
#include "base/terminal.h"
#include "experiments/reports.h"
#include "quadrature/gaussian_process.h"

namespace bmc {
// An error that is only rounding is 0, so that programs that multiply in another order agree.
static double absolute_error(double estimate, double truth) {
    const double error = std::fabs(estimate - truth);
    return error < 1e-12 * std::fabs(truth) ? 0 : error;
}

// The fresh directions of estimate e.
using DirectionsOf = std::function<std::vector<Vec3>(std::size_t e)>;

// Adds to rows[i] the errors of settings.mc_estimates estimates of integrands[i] by Monte Carlo. Estimate e is by the
// monte_carlo_rule of directions_of(e) for the density of the placement; make it once for all integrands.
// BEGIN SOLUTION table
static void add_mc_errors(std::vector<ErrorRow>& rows, const std::vector<Integrand>& integrands,
                          const ErrorSettings& settings, const DirectionsOf& directions_of) {
    for (std::size_t e = 0; e < settings.mc_estimates; ++e) {
        const QuadratureRule rule = monte_carlo_rule(directions_of(e), settings.placement.density);
        for (std::size_t i = 0; i < rows.size(); ++i)
            rows[i].mc.add(absolute_error(estimate(rule, integrands[i].value), integrands[i].truth));
    }
}
// END SOLUTION

// The same for settings.bmc_estimates Gaussian processes, which take the unknown_part of the values, and the absolute
// errors that they predict: a normal error of the standard deviation s, here the error bar of an estimate, has the mean
// absolute value sqrt(2 / pi) s.
// BEGIN SOLUTION table
static void add_bmc_errors(std::vector<ErrorRow>& rows, const std::vector<Integrand>& integrands,
                           const ErrorSettings& settings, const DirectionsOf& directions_of) {
    const std::shared_ptr<const Covariance> covariance = settings.make_covariance();
    for (std::size_t e = 0; e < settings.bmc_estimates; ++e) {
        const GaussianProcess process(*covariance, settings.noise, directions_of(e));
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::vector<double> values = unknown_part(integrands[i].value, process.directions, process.known);
            rows[i].bmc.add(absolute_error(process.integral(values), integrands[i].truth));
            rows[i].predicted.add(std::sqrt(2 / portable::pi) * process.error_bar(values));
        }
    }
}
// END SOLUTION

// Four digits, or nan for what is not finite: printf would print some as -nan.
static std::string cell(int width, double number) {
    return formatted("%*s", width, std::isfinite(number) ? formatted("%.4g", number).c_str() : "nan");
}

static std::string mean_cells(const Statistics& errors, int width) {
    const double plus_minus = errors.standard_error(), least = 1e-12 * errors.mean;
    return cell(width, errors.count > 0 ? errors.mean : NAN) + cell(10, plus_minus < least ? 0 : plus_minus);
}

std::vector<ErrorRow> error_rows(const std::vector<Integrand>& integrands, std::size_t samples,
                                 const ErrorSettings& settings) {
    Progress progress(formatted("estimates from %zu samples", samples), settings.mc_estimates + settings.bmc_estimates);
    std::vector<ErrorRow> rows(integrands.size(), ErrorRow{samples});
    const DirectionsOf directions_of = [&, drawn = directions_of_estimates(settings, samples)](std::size_t e) {
        progress.done();
        return drawn(e);
    };
    add_mc_errors(rows, integrands, settings, directions_of);
    try {
        add_bmc_errors(rows, integrands, settings, directions_of);
    } catch (const NotPositiveDefinite& error) {
        print_note(formatted("warning: no Gaussian process with %zu samples: ", samples) + error.what());
        for (ErrorRow& row : rows) row.bmc = row.predicted = {};
    }
    return rows;
}

// The slope of log error against log samples, by least squares, with its standard error from those of the rows.
static std::string slope_of(const std::vector<ErrorRow>& rows, Statistics ErrorRow::*errors) {
    Statistics x;  // the logarithms of the numbers of samples
    for (const ErrorRow& row : rows)
        if ((row.*errors).mean > 0) x.add(portable::log(static_cast<double>(row.samples)));
    double slope = 0, variance = 0;
    for (const ErrorRow& row : rows) {
        const Statistics& error = row.*errors;
        if (!(error.mean > 0)) continue;
        const double part = (portable::log(static_cast<double>(row.samples)) - x.mean) / x.squares;
        const double plus_minus = part * error.standard_error() / error.mean;
        slope += part * portable::log(error.mean);
        variance += plus_minus * plus_minus;
    }
    return x.squares > 0 && variance >= 0 ? formatted("%.3f +- %.3f", slope, std::sqrt(variance)) : "nan";
}

std::string error_report(const Integrand& integrand, const std::vector<ErrorRow>& rows, Placement placement) {
    std::string text = "# integral of " + integrand.formula + formatted(" = %.10f\n", integrand.truth) +
                       "# samples   mc_error        +-  bmc_error        +- bmc_predicted    mc/bmc mc_samples\n";
    const bool random = placement.set == PointSet::random;
    for (const ErrorRow& row : rows)
        text += formatted("%9zu", row.samples) + mean_cells(row.mc, 11) + mean_cells(row.bmc, 11) +
                cell(14, row.predicted.count > 0 ? row.predicted.mean : NAN) + cell(10, row.gain()) +
                cell(11, random ? row.equivalent_mc_samples() : NAN) + '\n';
    if (rows.size() < 3) return text;
    return text + "# slope of log error against log samples: mc " + slope_of(rows, &ErrorRow::mc) + ", bmc " +
           slope_of(rows, &ErrorRow::bmc) + '\n';
}

std::string error_tables(Arguments& arguments) {
    ErrorSettings settings;
    std::size_t chosen = 0;
    std::vector<std::string> names{"all"};
    names.insert(names.end(), std::begin(integrand_names), std::end(integrand_names));
    arguments.add(choice("integrand", names, 0, "", [&](std::size_t i) { chosen = i; }));
    add_sample_list(arguments, settings.sample_counts);
    arguments.add("mc-estimates", "M", "MC estimates averaged in each row", settings.mc_estimates, 1, 100000);
    arguments.add("bmc-estimates", "M", "BMC estimates averaged in each row", settings.bmc_estimates, 1, 100000);
    add_model_options(arguments, settings);
    arguments.take();
    std::vector<Integrand> integrands;
    for (const char* const name : integrand_names)
        if (chosen == 0 || names[chosen] == name) integrands.push_back(integrand_named(name));
    std::vector<std::vector<ErrorRow>> tables(integrands.size());
    std::string text;
    for (const std::size_t n : settings.sample_counts) {
        const std::vector<ErrorRow> rows = error_rows(integrands, n, settings);
        for (std::size_t i = 0; i < rows.size(); ++i) tables[i].push_back(rows[i]);
    }
    for (std::size_t i = 0; i < tables.size(); ++i)
        text += (i == 0 ? "" : "\n\n") + error_report(integrands[i], tables[i], settings.placement);
    return text;
}
}  // namespace bmc
