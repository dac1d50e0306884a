#include "experiments/integral_cost.h"

#include "experiments/statistics.h"
#include "experiments/stopwatch.h"
#include "quadrature/gaussian_process.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace {

constexpr const char* stages[] = {"drawing directions", "building Q", "factoring Q", "computing z",
                                  "solving for the weights"};
constexpr std::size_t stage_count = std::size(stages);

std::vector<double> stage_seconds(const Integrand& integrand, std::size_t n) {
    const Sobolev covariance;
    const double noise = ModelSettings().noise;
    Random random(1, n);
    const std::vector<Vec3> directions = uniform_directions(n, random);
    const Matrix q = covariance_matrix(covariance, noise, directions);
    const Cholesky cholesky(q);
    const std::vector<double> z = hemisphere_integrals(covariance, directions);
    const QuadratureRule rule{directions, cholesky.solve(z)};
    const std::function<double()> actions[] = {[&] { return uniform_directions(n, random).back().x; },
                                               [&] { return covariance_matrix(covariance, noise, directions)(0, 0); },
                                               [&] { return Cholesky(q).upper()(0, 0); },
                                               [&] { return hemisphere_integrals(covariance, directions).back(); },
                                               [&] { return cholesky.solve(z).back(); },
                                               [&] { return apply(rule, integrand); }};
    volatile double sink = 0;  // keeps the results, so that no stage is optimised away
    std::vector<double> seconds;
    for (const auto& action : actions) seconds.push_back(median_seconds([&] { sink = action(); }));
    return seconds;
}

// Of one uniform sample, times 2 pi.
double standard_deviation(const Integrand& integrand) {
    const Integrand square{"", "", [&](Vec3 w) { return integrand.value(w) * integrand.value(w); }, 0};
    return std::sqrt(2 * portable::pi * dense_quadrature(square) - integrand.truth * integrand.truth);
}

std::string costly_operation(const IntegralCost& row) {
    const auto most = std::max_element(row.seconds.begin(), row.seconds.begin() + stage_count);
    return line("# The costly operation at N = %zu is %s: %.0f %% of the time to make a rule.\n", row.samples,
                stages[most - row.seconds.begin()], 100 * *most / row.rule_seconds());
}

}  // namespace

double IntegralCost::rule_seconds() const {
    return std::accumulate(seconds.begin(), seconds.begin() + stage_count, 0.0);
}

double IntegralCost::equivalent_mc_samples() const {
    const double ratio = mc_error / bmc_error;
    return static_cast<double>(samples) * ratio * ratio;
}

double IntegralCost::integrals_to_pay_off() const {
    const double mc_sample = (seconds.front() + seconds.back()) / static_cast<double>(samples);
    return rule_seconds() / (equivalent_mc_samples() * mc_sample - seconds.back());
}

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

std::string integral_report(const std::vector<IntegralCost>& rows, bool timed) {
    std::string text =
        "# Root mean square errors; mc_samples: samples with which Monte Carlo has the error of Bayesian "
        "Monte Carlo.\n";
    if (timed)
        text +=
            "# Measured here: microseconds of each stage, and the integrals after which a rule made once has cost\n"
            "# less time than Monte Carlo at equal error.\n";
    text += line("# samples      mc_rmse     bmc_rmse   +-bmc_rmse   mc_samples%s\n",
                 timed ? "    draw_us       Q_us  factor_us       z_us weights_us  estim._us    pay_off" : "");
    for (const IntegralCost& row : rows) {
        text += line("%9zu %12.3g %12.3g %12.2g %12.3g", row.samples, row.mc_error, row.bmc_error, row.bmc_error_error,
                     row.equivalent_mc_samples());
        for (const double seconds : row.seconds) text += line(" %10.3g", 1e6 * seconds);
        text += timed ? line(" %10.3g\n", row.integrals_to_pay_off()) : "\n";
    }
    return timed ? text + costly_operation(rows.front()) + costly_operation(rows.back()) : text;
}
