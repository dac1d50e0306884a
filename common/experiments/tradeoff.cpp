#include "experiments/tradeoff.h"

#include "experiments/statistics.h"
#include "light/desert.h"
#include "quadrature/gaussian_process.h"

#include <algorithm>
#include <cmath>

namespace bmc {
namespace {

constexpr const char* stages[] = {"drawing directions", "building Q", "factoring Q", "computing z",
                                  "solving for the weights"};

std::vector<double> stage_seconds(const Integrand& integrand, std::size_t n) {
    const Sobolev covariance;
    const double noise = ModelSettings().noise;
    Random random(1, n);
    const std::vector<Vec3> directions = uniform_directions(n, random);
    const Matrix q = covariance_matrix(covariance, noise, directions);
    const Cholesky cholesky(q);
    const std::vector<double> z = z_of(covariance, directions);
    const QuadratureRule rule{directions, cholesky.solve(z)};
    const std::function<double()> actions[] = {[&] { return uniform_directions(n, random).back().x; },
                                               [&] { return covariance_matrix(covariance, noise, directions)(0, 0); },
                                               [&] { return Cholesky(q).upper()(0, 0); },
                                               [&] { return z_of(covariance, directions).back(); },
                                               [&] { return cholesky.solve(z).back(); },
                                               [&] { return apply(rule, integrand); }};
    volatile double sink = 0;  // keeps the results, so that no stage is optimised away
    std::vector<double> seconds;
    for (const auto& action : actions) seconds.push_back(seconds_of([&] { sink = action(); }));
    return seconds;
}

// Of one uniform sample, times 2 pi.
double standard_deviation(const Integrand& integrand) {
    const Integrand square{"", "", [&](Vec3 w) { return integrand.value(w) * integrand.value(w); }, 0};
    return std::sqrt(2 * portable::pi * dense_quadrature(square) - integrand.truth * integrand.truth);
}

std::string costly_operation(const IntegralCost& row) {
    const auto most = std::max_element(row.seconds.begin(), row.seconds.end() - 1);
    return formatted("# The costly operation at N = %zu is %s: %.0f %% of the time to make a rule.\n", row.samples,
                     stages[most - row.seconds.begin()], 100 * *most / row.rule_seconds());
}

// If the rows are timed, with the stage that takes most.
std::string integral_report(const std::vector<IntegralCost>& rows, bool timed) {
    std::string text =
        "# Root mean square errors; mc_samples: samples with which Monte Carlo has the error of Bayesian "
        "Monte Carlo.\n";
    if (timed)
        text +=
            "# Measured here: microseconds of each stage, and the integrals after which a rule made once has cost\n"
            "# less time than Monte Carlo at equal error.\n";
    text += formatted("# samples      mc_rmse     bmc_rmse   +-bmc_rmse   mc_samples%s\n",
                      timed ? "    draw_us       Q_us  factor_us       z_us weights_us  estim._us    pay_off" : "");
    for (const IntegralCost& row : rows) {
        text += formatted("%9zu %12.3g %12.3g %12.2g %12.3g", row.samples, row.mc_error, row.bmc_error,
                          row.bmc_error_uncertainty, row.equivalent_mc_samples());
        for (const double seconds : row.seconds) text += formatted(" %10.3g", 1e6 * seconds);
        text += timed ? formatted(" %10.3g\n", row.integrals_to_pay_off()) : "\n";
    }
    return timed ? text + costly_operation(rows.front()) + costly_operation(rows.back()) : text;
}

const char* const meaning =
    "# Against a dense quadrature, over 4 to 64 seeds. rmse: linear, over the pixels that show an object, with its\n"
    "# standard error; predicted: the rmse that two of the pictures predict; within: the share of errors within two\n"
    "# predicted ones; brightness: root mean square of the mean's relative error; correlation: of the errors of\n"
    "# neighbouring pixels, less their mean; mc_samples: samples with which mc has this rmse; known: what is known of\n"
    "# the integrand (shared: the light, and neighbours share what they see of it).\n";
const char* const measured =
    "# Measured here: seconds for a million pixels of objects on one core; efficiency, 1 / (rmse^2 seconds), is that\n"
    "# relative to mc.\n";

}  // namespace

std::vector<IntegralCost> integral_costs(const Integrand& integrand, std::uint64_t seed, bool timed) {
    const Sobolev covariance;
    ModelSettings settings;
    settings.seed = seed;
    const double deviation = standard_deviation(integrand);
    std::vector<IntegralCost> rows;
    for (const std::size_t n : {10u, 20u, 50u, 100u, 200u, 500u}) {
        RootMeanSquare error;
        for (std::size_t set = 0; set < std::clamp<std::size_t>(20000 / n, 50, 1000); ++set) {
            const std::vector<Vec3> directions = estimate_directions(settings, n, set).directions;
            error.add(apply(bayesian_rule(covariance, settings.noise, directions), integrand) - integrand.truth);
        }
        rows.push_back({n, deviation / std::sqrt(static_cast<double>(n)), error.value(), error.standard_error(), {}});
        if (timed) rows.back().seconds = stage_seconds(integrand, n);
    }
    return rows;
}

std::vector<Option> Tradeoff::options() {
    return {name_option("environment", "FILE", std::string(environment_help) + " (default: each built-in light)",
                        environment),
            count_option("size", "W", "of the pictures, W x W pixels (default 64)", costs.size, 1024, 2),
            seed_option("seed of the random numbers (default 1)", costs.seed),
            {"all", "", "more settings, with 10 to 160 samples, under one light (default: the desert)",
             [this](const std::string&) { all = true; }},
            {"no-times", "", "leave out what is measured and differs from run to run",
             [this](const std::string&) { costs.timed = false; }}};
}

std::string Tradeoff::report() const {
    std::vector<std::string> names{environment.empty() ? built_in_lights[0] : environment};
    if (environment.empty() && !all) names = {std::begin(built_in_lights), std::end(built_in_lights)};
    const Progress progress = terminal_progress("workbench");
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto light = std::make_shared<const EnvironmentMap>(load_environment(names[i]));
        if (i == 0)
            text = "# What an integral costs: " + names[i] + " above a tilted surface, Sobolev 3/2, noise 0.01.\n" +
                   integral_report(integral_costs(environment_integrand(light), costs.seed, costs.timed), costs.timed);
        const auto share = [&, count = static_cast<double>(names.size())](double done) {
            if (progress) progress((static_cast<double>(i) + done) / count);
        };
        text += "\n\n# What a picture costs: the sphere scene, " +
                formatted("%d x %d pixels, ", costs.size, costs.size) + "under " + names[i] + ".\n" + meaning +
                (costs.timed ? measured : "");
        const std::vector<PictureSettings> compared = compared_settings(all);
        const std::vector<std::size_t> samples =
            all ? std::vector<std::size_t>{10, 20, 40, 80, 160} : std::vector<std::size_t>{10, 40};
        text += picture_table(picture_costs(*light, compared, samples, costs, share), costs.timed);
    }
    return text;
}
}  // namespace bmc
