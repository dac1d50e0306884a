#include "experiments/tradeoff.h"

#include "experiments/picture_error.h"
#include "light/load_environment.h"
#include "numerics/statistics.h"

#include <algorithm>
#include <numeric>

namespace bmc {
constexpr const char* stages[] = {"drawing directions", "building Q", "factoring Q", "computing z",
                                  "solving for the weights"};

// z by its definition, the mean over 50,000 random directions times 2 pi, as programs without a closed form have it.
static std::vector<double> z_by_sum(const Covariance& covariance, const std::vector<Vec3>& directions) {
    Random random(1, 0);
    std::vector<double> z(directions.size());
    for (const Vec3& w : random_directions(50000, random))
        for (std::size_t j = 0; j < z.size(); ++j)
            z[j] += 2 * portable::pi / 50000 * covariance.k(squared_distance(w, directions[j]));
    return z;
}

static std::vector<double> stage_seconds(const Integrand& integrand, std::size_t n) {
    const Sobolev covariance;
    const double noise = ModelSettings().noise;
    Random random(1, n);
    const std::vector<Vec3> directions = random_directions(n, random);
    const Matrix q = covariance_matrix(covariance, noise, directions);
    const Cholesky cholesky(q);
    const std::vector<double> z = z_of(covariance, directions);
    const QuadratureRule rule{directions, cholesky.solve(z)};
    const std::function<double()> actions[] = {[&] { return random_directions(n, random).back().x; },
                                               [&] { return covariance_matrix(covariance, noise, directions)(0, 0); },
                                               [&] { return Cholesky(q).upper()(0, 0); },
                                               [&] { return z_of(covariance, directions).back(); },
                                               [&] { return cholesky.solve(z).back(); },
                                               [&] { return estimate(rule, integrand); },
                                               [&] { return z_by_sum(covariance, directions).back(); }};
    volatile double sink = 0;  // keeps the results, so that no stage is optimised away
    std::vector<double> seconds;
    for (const auto& action : actions) seconds.push_back(time_call([&] { sink = action(); }));
    return seconds;
}

// The standard deviation of 2 pi f(w) for a uniform direction w.
static double standard_deviation(const Integrand& integrand) {
    const Integrand square{"", "", [&](Vec3 w) { return integrand.value(w) * integrand.value(w); }, 0};
    return std::sqrt(2 * portable::pi * reference_integral(square) - integrand.truth * integrand.truth);
}

static std::string costly_operation(const IntegralCost& row) {
    const auto most = std::max_element(row.seconds.begin(), row.seconds.begin() + 5);
    return formatted("# The costly operation at N = %zu is %s: %.0f %% of the time to make a rule.\n", row.samples,
                     stages[most - row.seconds.begin()], 100 * *most / row.rule_seconds());
}

static std::string integral_report(const std::vector<IntegralCost>& rows, bool timed) {
    std::string text =
        "# Root mean square errors; mc_samples: samples with which Monte Carlo has the error of Bayesian Monte "
        "Carlo.\n";
    if (timed)
        text +=
            "# Measured here: microseconds of each stage; of z by 50,000 random directions in place of its closed "
            "form; and\n"
            "# the integrals after which a rule made once has cost less time than Monte Carlo at equal error.\n";
    text += formatted(
        "# samples      mc_rmse     bmc_rmse   +-bmc_rmse   mc_samples%s\n",
        timed ? "    draw_us       Q_us  factor_us       z_us weights_us  estim._us  z50000_us    pay_off" : "");
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
    "# standard error; correlation: of the errors of neighbouring pixels, less their mean; brightness: root mean "
    "square\n"
    "# of the mean's relative error; mc_samples: samples with which mc has this rmse; known: what is known of the\n"
    "# integrand.\n";
const char* const measured =
    "# Measured here: seconds for a million pixels of objects on one processor; efficiency, 1 / (rmse^2 seconds), is\n"
    "# that relative to mc.\n";

double IntegralCost::rule_seconds() const { return std::accumulate(seconds.begin(), seconds.begin() + 5, 0.0); }

double IntegralCost::equivalent_mc_samples() const {
    return static_cast<double>(samples) * (mc_error / bmc_error) * (mc_error / bmc_error);
}

double IntegralCost::integrals_to_pay_off() const {
    const double mc_sample = (seconds[0] + seconds[5]) / static_cast<double>(samples);
    return rule_seconds() / (equivalent_mc_samples() * mc_sample - seconds[5]);
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
            const std::vector<Vec3> directions = directions_of_estimate(settings, n, set).directions;
            error.add(estimate(bayesian_rule(covariance, settings.noise, directions), integrand) - integrand.truth);
        }
        rows.push_back({n, deviation / std::sqrt(static_cast<double>(n)), error.value(), error.standard_error(), {}});
        if (timed) rows.back().seconds = stage_seconds(integrand, n);
    }
    return rows;
}

Options TradeoffReport::options() {
    return joined({Options{text_option("environment", "FILE",
                                       "one light, as for the renderer (default: each built-in light)", environment),
                           {"all", "", "more settings, with 10 to 160 samples, under one light (default desert)",
                            [this](const std::string&) { all = true; }}},
                   cost_options(costs)});
}

std::string TradeoffReport::report() const {
    std::vector<std::string> names{environment.empty() ? built_in_lights[0] : environment};
    if (environment.empty() && !all) names = {std::begin(built_in_lights), std::end(built_in_lights)};
    const std::vector<std::size_t> samples =
        all ? std::vector<std::size_t>{10, 20, 40, 80, 160} : std::vector<std::size_t>{10, 40};
    std::string text;
    for (const std::string& name : names) {
        const auto light = std::make_shared<const EnvironmentMap>(load_environment(name));
        if (text.empty())
            text = "# What an integral costs: " + name + " above a tilted surface, Sobolev 3/2, noise 0.01.\n" +
                   integral_report(integral_costs(environment_integrand(light), costs.seed, costs.timed), costs.timed);
        const Image truth = reference_image(*light, row_settings(costs, {}, 0), 10000);
        text +=
            formatted("\n\n# What a picture costs: the sphere scene, %d x %d pixels, under ", costs.size, costs.size) +
            name + ".\n" + meaning + (costs.timed ? measured : "") +
            picture_table(picture_costs(compared_pictures(*light, all), samples, costs, truth), costs.timed);
    }
    return text;
}
}  // namespace bmc
