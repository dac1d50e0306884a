#include "experiments/models.h"

#include "experiments/scene_integrands.h"

#include "quadrature/gaussian_process.h"

#include <algorithm>
#include <cmath>

using portable::pi;

namespace {

std::string model_name(const ModelRow& row) {
    return line("%s %g with noise %g", row.model.name(), row.model.parameter, row.noise);
}

std::string model_table(const std::vector<ModelRow>& rows) {
    std::string text =
        "# covariance        parameter  noise       rmse  predicted coverage log_evidence leave_one_out "
        "amplification\n";
    for (const ModelRow& row : rows)
        text += line("%-20s %8g %6g %10.5g %10.5g %8.4f %12.5g %13.5g %13.5g\n", row.model.name(), row.model.parameter,
                     row.noise, row.rmse, row.predicted, row.coverage, row.log_evidence, row.leave_one_out,
                     row.amplification);
    return text;
}

// The models that the table's columns choose, with the error that each choice brings.
std::string choices(const std::vector<ModelRow>& rows, double mc_rmse) {
    const auto least = [&](auto key) {
        return *std::min_element(rows.begin(), rows.end(),
                                 [&](const ModelRow& a, const ModelRow& b) { return key(a) < key(b); });
    };
    const ModelRow best = least([](const ModelRow& row) { return row.rmse; });
    const ModelRow evident = least([](const ModelRow& row) { return -row.log_evidence; });
    const ModelRow left_out = least([](const ModelRow& row) { return row.leave_one_out; });
    return line("# Monte Carlo on the same sets has RMSE %.5g. In hindsight the best is %s: %.5g.\n", mc_rmse,
                model_name(best).c_str(), best.rmse) +
           line("# Without the truth, the evidence chooses %s: %.5g;\n#   the leave-one-out error chooses %s: %.5g.\n",
                model_name(evident).c_str(), evident.rmse, model_name(left_out).c_str(), left_out.rmse);
}

std::string range_of_errors(const std::vector<ModelRow>& rows, CovarianceFamily family, double noise) {
    double low = 1e300, high = 0;
    for (const ModelRow& row : rows) {
        if (row.model.family != family || row.noise != noise) continue;
        low = std::min(low, row.rmse);
        high = std::max(high, row.rmse);
    }
    return line("%s with noise %g %.3g to %.3g", name_of(family, covariance_names), noise, low, high);
}

// Adds what the process says of the integrand to the sums of a row.
void add(ModelRow& row, const GaussianProcess& process, const Matrix& inverse, const Integrand& integrand) {
    const std::vector<double> values = sample(integrand, process.directions());
    const double n = static_cast<double>(values.size());
    const double error = process.integral(values) - integrand.truth, predicted = process.standard_error(values);
    row.rmse += error * error;
    row.predicted += predicted * predicted;
    row.coverage += std::fabs(error) <= 2 * predicted;
    row.log_evidence += process.log_evidence(values) / n;
    for (const double residual : process.leave_one_out(values, inverse)) row.leave_one_out += residual * residual / n;
}

}  // namespace

std::vector<Model> compared_models() {
    std::vector<Model> models;
    for (double s : {1.1, 1.25, 1.4, 1.5, 1.8}) models.emplace_back(CovarianceFamily::sobolev, s);
    for (double l : {0.25, 0.5, 1.0, 2.0}) models.emplace_back(CovarianceFamily::squared_exponential, l);
    return models;
}

std::vector<ModelRow> judge(const Model& model, double noise, const std::vector<std::vector<Integrand>>& groups,
                            std::size_t n, std::size_t sets) {
    std::vector<ModelRow> rows(groups.size(), ModelRow{model, noise, 0, 0, 0, 0, 0, 0});
    for (std::size_t set = 0; set < sets; ++set) {
        const GaussianProcess process(*model.covariance, noise, estimate_directions({}, n, set).directions);
        const Matrix inverse = process.inverse_covariance();
        for (std::size_t group = 0; group < groups.size(); ++group) {
            for (const double weight : process.weights()) rows[group].amplification += std::fabs(weight) / (2 * pi);
            for (const Integrand& integrand : groups[group]) add(rows[group], process, inverse, integrand);
        }
    }
    for (std::size_t group = 0; group < groups.size(); ++group) {
        ModelRow& row = rows[group];
        const double estimates = static_cast<double>(sets * groups[group].size());
        row.rmse = std::sqrt(row.rmse / estimates);
        row.predicted = std::sqrt(row.predicted / estimates);
        row.coverage /= estimates;
        row.log_evidence /= estimates;
        row.leave_one_out = std::sqrt(row.leave_one_out / estimates);
        row.amplification /= static_cast<double>(sets);
    }
    return rows;
}

double monte_carlo_rmse(const std::vector<Integrand>& integrands, std::size_t n, std::size_t sets) {
    double squares = 0;
    for (std::size_t set = 0; set < sets; ++set) {
        const QuadratureRule rule = monte_carlo_rule(estimate_directions({}, n, set));
        for (const Integrand& integrand : integrands) {
            const double error = apply(rule, integrand) - integrand.truth;
            squares += error * error;
        }
    }
    return std::sqrt(squares / static_cast<double>(sets * integrands.size()));
}

Bias bias_of(const std::vector<Integrand>& integrands, std::size_t n, std::size_t sets) {
    const Sobolev covariance;
    const double count = static_cast<double>(sets);
    double sum = 0, squares = 0;
    for (std::size_t set = 0; set < sets; ++set) {
        const QuadratureRule rule = bayesian_rule(covariance, 1e-2, estimate_directions({}, n, set).directions);
        double estimate = 0, truth = 0;
        for (const Integrand& integrand : integrands) {
            estimate += apply(rule, integrand);
            truth += integrand.truth;
        }
        const double error = estimate / truth - 1;
        sum += error;
        squares += error * error;
    }
    const double mean = sum / count;
    return {mean, std::sqrt((squares / count - mean * mean) / (count - 1))};
}

std::string Models::report() const {
    constexpr std::size_t n = 40, sets = 200;
    const std::vector<Integrand> smooth{practice_integrands()[1]}, radiance = scene_integrands();
    std::vector<ModelRow> smooth_rows, radiance_rows;
    for (const Model& model : compared_models())
        for (const double noise : {1e-3, 1e-2, 1e-1}) {
            const std::vector<ModelRow> rows = judge(model, noise, {smooth, radiance}, n, sets);
            smooth_rows.push_back(rows[0]);
            radiance_rows.push_back(rows[1]);
        }
    const double mc_rmse = monte_carlo_rmse(radiance, n, sets);
    std::string text =
        "# What cos(theta) requires: 200 random sets of 40 directions.\n" + model_table(smooth_rows) +
        choices(smooth_rows, monte_carlo_rmse(smooth, n, sets)) +
        "\n\n# What a scene requires: incident radiance times cos(theta) at five points, the same sets.\n" +
        model_table(radiance_rows) + choices(radiance_rows, mc_rmse) +
        "\n\n# Is the error bar honest? Fraction of errors within two predicted standard errors on the same radiance.\n"
        "# smoothness samples       rmse  predicted coverage\n";
    constexpr std::size_t counts[] = {20, 40, 80, 160};
    for (const double s : {1.25, 1.5, 1.8})
        for (const std::size_t count : counts) {
            const ModelRow row = judge({CovarianceFamily::sobolev, s}, 1e-2, {radiance}, count, sets)[0];
            text += line("%12g %7zu %10.5g %10.5g %8.4f\n", s, count, row.rmse, row.predicted, row.coverage);
        }
    text +=
        "# RMSE on radiance: " + range_of_errors(radiance_rows, CovarianceFamily::sobolev, 1e-2) + ";\n#   " +
        range_of_errors(radiance_rows, CovarianceFamily::squared_exponential, 1e-2) + ", " +
        range_of_errors(radiance_rows, CovarianceFamily::squared_exponential, 1e-1) +
        line("; Monte Carlo %.3g.\n", mc_rmse) +
        "\n\n# Which way does a zero mean pull? Mean relative errors over 2000 sets, each with its standard error: a "
        "constant\n"
        "# comes out too small, but not what vanishes at the horizon, which the process does not know.\n"
        "# samples   constant        +-     cosine        +-   radiance        +-\n";
    for (const std::size_t count : {10u, 20u, 40u, 80u, 160u}) {
        text += line("%9zu", count);
        for (const std::vector<Integrand>& integrands :
             {std::vector<Integrand>{practice_integrands()[0]}, smooth, radiance}) {
            const Bias bias = bias_of(integrands, count, 2000);
            text += line(" %10.5f %9.5f", bias.mean, bias.standard_error);
        }
        text += '\n';
    }
    return text;
}
