#include "experiments/tradeoff.h"

#include "experiments/picture_error.h"
#include "experiments/stopwatch.h"
#include "quadrature/gaussian_process.h"
#include "scene/desert.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>

namespace {

constexpr double default_noise = 0.01;

StageTimes stage_times(const Integrand& integrand, std::size_t n) {
    const Sobolev covariance;
    Random random(1, n);
    std::vector<Vec3> directions = uniform_directions(n, random);
    const Matrix q = covariance_matrix(covariance, default_noise, directions);
    const Cholesky cholesky(q);
    const std::vector<double> z = hemisphere_integrals(covariance, directions);
    const QuadratureRule rule{directions, cholesky.solve(z)};
    volatile double sink = 0;  // keeps the results, so that no stage is optimised away
    StageTimes seconds;
    seconds.draw = median_seconds([&] { sink = uniform_directions(n, random).back().x; });
    seconds.covariance = median_seconds([&] { sink = covariance_matrix(covariance, default_noise, directions)(0, 0); });
    seconds.factor = median_seconds([&] { sink = Cholesky(q).upper()(0, 0); });
    seconds.z = median_seconds([&] { sink = hemisphere_integrals(covariance, directions).back(); });
    seconds.weights = median_seconds([&] { sink = cholesky.solve(z).back(); });
    seconds.estimate = median_seconds([&] { sink = apply(rule, integrand); });
    return seconds;
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

std::vector<IntegralCost> integral_costs(const Integrand& integrand, bool timed) {
    const Sobolev covariance;
    std::vector<IntegralCost> rows;
    constexpr std::size_t counts[] = {10, 20, 50, 100, 200, 500, 1000};
    for (const std::size_t n : counts) {
        const std::size_t sets = std::max<std::size_t>(10, 4000 / n);
        double mc = 0, bmc = 0;
        for (std::size_t set = 0; set < sets; ++set) {
            const DirectionSet drawn = estimate_directions({}, n, set);
            const double mc_error = apply(monte_carlo_rule(drawn), integrand) - integrand.truth;
            const double bmc_error =
                apply(bayesian_rule(covariance, default_noise, drawn.directions), integrand) - integrand.truth;
            mc += mc_error * mc_error;
            bmc += bmc_error * bmc_error;
        }
        const double count = static_cast<double>(sets);
        rows.push_back(
            {n, std::sqrt(mc / count), std::sqrt(bmc / count), timed ? stage_times(integrand, n) : StageTimes{}});
    }
    return rows;
}

namespace {

constexpr int timed_size = 64;
constexpr int timed_runs = 4;

// Seconds of one rendering on one core, the best of a few.
double fastest_render(const Scene& scene, const Light& light, const RenderSettings& settings) {
    double fastest = 0;
    for (int run = 0; run < timed_runs; ++run) {
        const double seconds = seconds_of([&] { render(scene, light, settings); });
        fastest = run == 0 ? seconds : std::min(fastest, seconds);
    }
    return fastest;
}

// The rules are made once whatever the size: their time, that of a picture of one pixel, is told from the pixels' time,
// which is that of a picture large enough for the clock, whatever the size of the others.
double seconds_per_megapixel(const Scene& scene, const Light& light, RenderSettings settings) {
    settings.threads = 1;
    settings.width = settings.height = timed_size;
    const double whole = fastest_render(scene, light, settings);
    settings.width = settings.height = 1;
    const double rules = fastest_render(scene, light, settings);
    return rules + 1e6 * std::max(0.0, whole - rules) / object_pixels(scene, timed_size, timed_size);
}

// Every way to render that is compared, but for the number of samples.
std::vector<RenderSettings> compared_settings() {
    std::vector<RenderSettings> list;
    const auto add = [&](Method method, std::size_t pool, Placement placement, Prior prior = {}) {
        RenderSettings settings;
        settings.method = method;
        settings.pool = pool;
        settings.placement = placement;
        settings.prior = prior;
        list.push_back(settings);
    };
    const auto both = {Placement::uniform, Placement::fibonacci};
    for (const Method method : {Method::mc, Method::direct, Method::single, Method::rotated})
        for (const Placement placement : both) add(method, 1, placement);
    for (const std::size_t pool : {1u, 2u, 5u, 20u})
        for (const Placement placement : both) add(Method::pool, pool, placement);
    for (const Placement placement : {Placement::cosine, Placement::cosine_fibonacci}) add(Method::mc, 1, placement);
    for (const Placement placement : both) add(Method::pool, 20, placement, {KnownPart::nothing, PriorMean::uniform});
    for (const PriorMean mean : {PriorMean::zero, PriorMean::uniform})
        for (const Placement placement : {Placement::uniform, Placement::cosine, Placement::cosine_fibonacci})
            add(Method::pool, 20, placement, {KnownPart::cosine, mean});
    for (const Placement placement : {Placement::uniform, Placement::cosine_fibonacci}) {
        add(Method::mc, 1, placement, {KnownPart::light, PriorMean::zero});
        add(Method::pool, 20, placement, {KnownPart::light, PriorMean::zero});
    }
    return list;
}

}  // namespace

namespace {

bool shares_rules(const RenderSettings& settings) {
    return is_lattice(settings.placement) ? settings.method != Method::direct
                                          : settings.method != Method::mc && settings.method != Method::direct;
}

// Where pixels share rules, 64 rules make the standard error of the RMSE a few per cent of it; large pictures take
// fewer, for the time. Elsewhere every pixel is a sample, and a few seeds do.
std::uint64_t seeds_of(const RenderSettings& settings) {
    if (!shares_rules(settings) || settings.width > 128) return 4;
    return std::max<std::uint64_t>(16, 64 / settings.pool);
}

// How long a row takes, in rays of a pixel: to factor Q costs direct as much as n^2 / 10 rays a sample.
double work_of(const RenderSettings& settings) {
    const double n = static_cast<double>(settings.samples);
    return static_cast<double>(seeds_of(settings)) * n * (settings.method == Method::direct ? 10 + n / 10 : 1);
}

PictureCost picture_cost(const Scene& scene, const Light& light, RenderSettings settings, const std::vector<bool>& mask,
                         const Image& truth) {
    const std::uint64_t seeds = seeds_of(settings);
    double squares = 0, fourth_powers = 0, correlation = 0, brightness = 0;
    for (settings.seed = 1; settings.seed <= seeds; ++settings.seed) {
        const ImageError error = image_error(mask, render(scene, light, settings), truth);
        const double squared = error.rmse * error.rmse;
        squares += squared;
        fourth_powers += squared * squared;
        correlation += error.correlation;
        brightness += error.brightness * error.brightness;
    }
    // The standard error of the mean square, over the derivative of the square.
    const double count = static_cast<double>(seeds), mean = squares / count, rmse = std::sqrt(mean);
    const double variance = std::max(0.0, fourth_powers / count - mean * mean) / (count - 1);
    return {settings,
            rmse,
            rmse > 0 ? std::sqrt(variance) / (2 * rmse) : 0,
            correlation / count,
            std::sqrt(brightness / count),
            0};
}

}  // namespace

std::vector<PictureCost> picture_costs(const EnvironmentMap& environment, int size, bool timed,
                                       const Progress& progress) {
    const Scene scene = sphere_scene();
    const Light light(environment);
    const auto sized = [&](RenderSettings settings, std::size_t samples) {
        settings.samples = samples;
        settings.width = settings.height = size;
        settings.threads = std::max(1u, std::thread::hardware_concurrency());
        return settings;
    };
    RenderSettings dense;
    dense.method = Method::mc;
    dense.placement = Placement::fibonacci;
    const Image truth = render(scene, light, sized(dense, 20000));
    const std::vector<bool> mask = object_mask(scene, size, size);
    if (!(image_error(mask, truth, truth).brightness == 0))  // 0 / 0
        throw std::invalid_argument("the environment lights no object, so there is no error to compare; take another");

    std::vector<RenderSettings> rows;
    for (const RenderSettings& compared : compared_settings())
        for (const std::size_t samples : {10u, 20u, 40u, 80u, 160u}) rows.push_back(sized(compared, samples));
    double all = 20000, done = 20000;
    for (const RenderSettings& row : rows) all += work_of(row);
    std::vector<PictureCost> costs;
    for (const RenderSettings& row : rows) {
        if (progress) progress(done / all);
        costs.push_back(picture_cost(scene, light, row, mask, truth));
        if (timed) costs.back().seconds_per_megapixel = seconds_per_megapixel(scene, light, row);
        done += work_of(row);
    }
    if (progress) progress(1);
    return costs;
}

namespace {

std::string integral_table(const std::vector<IntegralCost>& rows, bool timed) {
    std::string text =
        line("# samples      mc_rmse     bmc_rmse   mc_samples%s\n",
             timed ? "    draw_us       Q_us  factor_us       z_us weights_us  estim._us    pay_off" : "");
    for (const IntegralCost& row : rows) {
        text +=
            line("%9zu %12.5g %12.5g %12.5g", row.samples, row.mc_error, row.bmc_error, row.equivalent_mc_samples());
        const StageTimes& s = row.seconds;
        if (timed) {
            for (const double seconds : {s.draw, s.covariance, s.factor, s.z, s.weights, s.estimate})
                text += line(" %10.3g", 1e6 * seconds);
            text += line(" %10.3g", row.integrals_to_pay_off());
        }
        text += '\n';
    }
    return text;
}

std::string costly_operation(const std::vector<IntegralCost>& rows) {
    std::string text;
    for (const IntegralCost& row : {rows.front(), rows.back()}) {
        const StageTimes& s = row.seconds;
        const auto [seconds, name] =
            std::max({std::pair(s.draw, "drawing directions"), std::pair(s.covariance, "building Q"),
                      std::pair(s.factor, "factoring Q"), std::pair(s.z, "computing z"),
                      std::pair(s.weights, "solving for the weights")});
        text += line("# The costly operation at N = %zu is %s: %.0f %% of the time to make a rule.\n", row.samples,
                     name, 100 * seconds / s.rule());
    }
    return text;
}

// What to type for the settings of a row.
std::string settings_of(const PictureCost& row) {
    const RenderSettings& s = row.settings;
    return line("--method %s", name_of(s.method, method_names)) +
           (s.method == Method::pool ? line(" --pool %zu", s.pool) : "") +
           line(" --placement %s", name_of(s.placement, placement_names)) +
           (s.prior.known == KnownPart::nothing ? "" : line(" --known %s", name_of(s.prior.known, known_part_names))) +
           (s.prior.mean == PriorMean::uniform ? " --mean uniform" : "") + line(" --samples %zu", s.samples);
}

// The row of classic Monte Carlo on random directions with as many samples.
const PictureCost& classic(const std::vector<PictureCost>& rows, const PictureCost& row) {
    return *std::find_if(rows.begin(), rows.end(), [&](const PictureCost& other) {
        return other.settings.method == Method::mc && other.settings.placement == Placement::uniform &&
               other.settings.samples == row.settings.samples;
    });
}

double squared_ratio(double a, double b) { return a * a / (b * b); }

std::string picture_table(const std::vector<PictureCost>& rows, bool timed) {
    std::string text = line(
        "# method  pool placement        known   mean    samples       rmse     +-rmse correlation brightness "
        "mc_samples%s\n",
        timed ? "  s/megapixel efficiency" : "");
    for (const PictureCost& row : rows) {
        const RenderSettings& s = row.settings;
        const PictureCost& mc = classic(rows, row);
        const double gain = squared_ratio(mc.rmse, row.rmse);
        text += line("%-8s %5zu %-16s %-7s %-7s %7zu %10.5f %10.5f %11.4f %10.5f %10.4g",
                     name_of(s.method, method_names), s.pool, name_of(s.placement, placement_names),
                     name_of(s.prior.known, known_part_names), name_of(s.prior.mean, prior_mean_names), s.samples,
                     row.rmse, row.rmse_error, row.correlation, row.brightness, static_cast<double>(s.samples) * gain);
        if (timed)
            text += line(" %12.3g %10.3g", row.seconds_per_megapixel,
                         gain * mc.seconds_per_megapixel / row.seconds_per_megapixel);
        text += '\n';
    }
    return text;
}

// An eye takes errors for noise only if neighbouring pixels do not share them.
constexpr double most_correlation = 0.1;

std::string cheapest_settings(const std::vector<PictureCost>& rows, bool timed) {
    const auto cost = [&](const PictureCost& row) {
        return timed ? row.seconds_per_megapixel : static_cast<double>(row.settings.samples);
    };
    std::string text = line(
        "# The %s for an RMSE, of the settings whose errors an eye takes for noise, their correlation being at most "
        "%g:\n",
        timed ? "least time" : "fewest samples", most_correlation);
    for (const double target : {0.04, 0.02, 0.01}) {
        const PictureCost* best = nullptr;
        for (const PictureCost& row : rows)
            if (row.rmse <= target && std::fabs(row.correlation) <= most_correlation &&
                (!best || std::pair(cost(row), row.rmse) < std::pair(cost(*best), best->rmse)))
                best = &row;
        text += line("# RMSE %.2f: ", target) + (best ? settings_of(*best) : "none of these") + '\n';
    }
    return text;
}

}  // namespace

std::vector<Option> Tradeoff::options() {
    return {
        {"environment", "FILE", environment_help, [this](const std::string& text) { environment = parse_name(text); }},
        {"size", "W", "of the pictures, W x W pixels (default 64)",
         [this](const std::string& text) { size = static_cast<int>(parse_integer(text, 2, 1024)); }},
        {"no-times", "", "leave out what is measured and differs from run to run",
         [this](const std::string&) { timed = false; }}};
}

std::string Tradeoff::report() const {
    const EnvironmentMap light = load_environment(environment);  // first of all, since it may not be there
    const std::vector<IntegralCost> integrals = integral_costs(practice_integrands().back(), timed);
    const std::vector<PictureCost> pictures = picture_costs(light, size, timed, terminal_progress("workbench"));
    return "# What an integral costs: the environment integrand, Sobolev 3/2, noise 0.01; errors are root mean "
           "squares.\n"
           "# mc_samples: samples with which Monte Carlo has the error of Bayesian Monte Carlo.\n" +
           std::string(timed ? "# Measured here: microseconds of each stage, and the integrals after which a rule made "
                               "once has cost\n"
                               "# less time than Monte Carlo at equal error.\n"
                             : "") +
           integral_table(integrals, timed) + (timed ? costly_operation(integrals) : "") +
           "\n\n# What a picture costs: the sphere scene against a dense quadrature, over 4 seeds, 16 to 64 where "
           "pixels share\n"
           "# rules. rmse: linear, over the pixels that show an object, with its standard error; correlation: of the "
           "errors of\n"
           "# neighbouring pixels; brightness: root mean square of the mean's relative error; mc_samples: samples with "
           "which mc\n"
           "# has this rmse.\n" +
           (timed ? "# Measured here: seconds for a megapixel of objects on one core, and 1 / (rmse^2 seconds) "
                    "relative to mc.\n"
                  : "") +
           picture_table(pictures, timed) + cheapest_settings(pictures, timed);
}
