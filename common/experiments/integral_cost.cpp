#include "experiments/integral_cost.h"

#include "experiments/root_mean_square.h"
#include "experiments/stopwatch.h"
#include "quadrature/gaussian_process.h"

#include <algorithm>
#include <cmath>

namespace {

StageTimes stage_times(const Integrand& integrand, std::size_t n) {
    const Sobolev covariance;
    const double noise = ModelSettings().noise;
    Random random(1, n);
    const std::vector<Vec3> directions = uniform_directions(n, random);
    const Matrix q = covariance_matrix(covariance, noise, directions);
    const Cholesky cholesky(q);
    const std::vector<double> z = hemisphere_integrals(covariance, directions);
    const QuadratureRule rule{directions, cholesky.solve(z)};
    volatile double sink = 0;  // keeps the results, so that no stage is optimised away
    StageTimes seconds;
    seconds.draw = median_seconds([&] { sink = uniform_directions(n, random).back().x; });
    seconds.covariance = median_seconds([&] { sink = covariance_matrix(covariance, noise, directions)(0, 0); });
    seconds.factor = median_seconds([&] { sink = Cholesky(q).upper()(0, 0); });
    seconds.z = median_seconds([&] { sink = hemisphere_integrals(covariance, directions).back(); });
    seconds.weights = median_seconds([&] { sink = cholesky.solve(z).back(); });
    seconds.estimate = median_seconds([&] { sink = apply(rule, integrand); });
    return seconds;
}

// Of one uniform sample, times 2 pi.
double standard_deviation(const Integrand& integrand) {
    const Integrand square{"", "", [&](Vec3 w) { return integrand.value(w) * integrand.value(w); }, 0};
    return std::sqrt(2 * portable::pi * dense_quadrature(square) - integrand.truth * integrand.truth);
}

std::string costly_operation(const IntegralCost& row) {
    const StageTimes& s = row.seconds;
    const auto [seconds, name] =
        std::max({std::pair(s.draw, "drawing directions"), std::pair(s.covariance, "building Q"),
                  std::pair(s.factor, "factoring Q"), std::pair(s.z, "computing z"),
                  std::pair(s.weights, "solving for the weights")});
    return line("# The costly operation at N = %zu is %s: %.0f %% of the time to make a rule.\n", row.samples, name,
                100 * seconds / s.rule());
}

}  // namespace

double IntegralCost::equivalent_mc_samples() const {
    const double ratio = mc_error / bmc_error;
    return static_cast<double>(samples) * ratio * ratio;
}

double IntegralCost::integrals_to_pay_off() const {
    const double mc_sample = (seconds.draw + seconds.estimate) / static_cast<double>(samples);
    return seconds.rule() / (equivalent_mc_samples() * mc_sample - seconds.estimate);
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
        rows.push_back({n, deviation / std::sqrt(static_cast<double>(n)), error.value(), error.standard_error(),
                        timed ? stage_times(integrand, n) : StageTimes{}});
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
        const StageTimes& s = row.seconds;
        if (timed) {
            for (const double seconds : {s.draw, s.covariance, s.factor, s.z, s.weights, s.estimate})
                text += line(" %10.3g", 1e6 * seconds);
            text += line(" %10.3g", row.integrals_to_pay_off());
        }
        text += '\n';
    }
    return timed ? text + costly_operation(rows.front()) + costly_operation(rows.back()) : text;
}
