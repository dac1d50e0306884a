#include "experiments/tradeoff.h"

#include "quadrature/gaussian_process.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace {

using Clock = std::chrono::steady_clock;

constexpr double default_noise = 0.01;

// Median seconds of an action; actions that are too short for the clock are repeated.
template <class Action>
double median_seconds(std::size_t repetitions, Action action) {
    std::vector<double> seconds;
    for (int run = 0; run < 7; ++run) {
        const Clock::time_point start = Clock::now();
        for (std::size_t i = 0; i < repetitions; ++i) action();
        seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count() /
                          static_cast<double>(repetitions));
    }
    std::sort(seconds.begin(), seconds.end());
    return seconds[3];
}

StageTimes stage_times(const Integrand& integrand, std::size_t n) {
    const Sobolev covariance;
    Random random(1, n);
    std::vector<Vec3> directions = uniform_directions(n, random);
    const Matrix q = covariance_matrix(covariance, default_noise, directions);
    const Cholesky cholesky(q);
    const std::vector<double> z = hemisphere_integrals(covariance, directions);
    const QuadratureRule rule{directions, cholesky.solve(z)};
    const std::size_t repetitions = 1 + 2000 / n;
    volatile double sink = 0;  // keeps the results, so that no stage is optimised away
    StageTimes seconds;
    seconds.draw = median_seconds(repetitions, [&] { sink = uniform_directions(n, random).back().x; });
    seconds.covariance =
        median_seconds(repetitions, [&] { sink = covariance_matrix(covariance, default_noise, directions)(0, 0); });
    seconds.factor = median_seconds(repetitions, [&] { sink = Cholesky(q).upper()(0, 0); });
    seconds.z = median_seconds(repetitions, [&] { sink = hemisphere_integrals(covariance, directions).back(); });
    seconds.weights = median_seconds(repetitions, [&] { sink = cholesky.solve(z).back(); });
    seconds.estimate = median_seconds(repetitions, [&] { sink = apply(rule, integrand); });
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
            Random random(1, (std::uint64_t{n} << 32) + set);
            const std::vector<Vec3> directions = uniform_directions(n, random);
            const double mc_error = apply(monte_carlo_rule(directions), integrand) - integrand.truth;
            const double bmc_error =
                apply(bayesian_rule(covariance, default_noise, directions), integrand) - integrand.truth;
            mc += mc_error * mc_error;
            bmc += bmc_error * bmc_error;
        }
        const double count = static_cast<double>(sets);
        rows.push_back(
            {n, std::sqrt(mc / count), std::sqrt(bmc / count), timed ? stage_times(integrand, n) : StageTimes{}});
    }
    return rows;
}

double object_pixels(const Scene& scene, int width, int height) {
    const Camera camera{width, height};
    double count = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) count += intersect(scene, camera.ray(x, y)).has_value();
    return count;
}

ImageError image_error(const Scene& scene, const std::vector<Image>& images, const Image& truth) {
    const Camera camera{truth.width(), truth.height()};
    const auto shows_object = [&](int x, int y) { return intersect(scene, camera.ray(x, y)).has_value(); };
    double count = 0, sum = 0, true_sum = 0, squares = 0, products = 0, pair_squares = 0;
    for (int y = 0; y < truth.height(); ++y)
        for (int x = 0; x < truth.width(); ++x) {
            if (!shows_object(x, y)) continue;
            const bool has_neighbour = x + 1 < truth.width() && shows_object(x + 1, y);
            for (const Image& image : images) {
                const Color here = image(x, y), error = here - truth(x, y);
                const double squared = dot(error, error);
                count += 3;
                sum += here.x + here.y + here.z;
                true_sum += truth(x, y).x + truth(x, y).y + truth(x, y).z;
                squares += squared;
                if (!has_neighbour) continue;
                const Color next = image(x + 1, y) - truth(x + 1, y);
                products += dot(error, next);
                pair_squares += (squared + dot(next, next)) / 2;
            }
        }
    return {std::sqrt(squares / count), products / pair_squares, sum / true_sum - 1};
}

namespace {

constexpr std::uint64_t seeds = 4;

// Seconds of one rendering on one core, the best of the seeds.
double fastest_render(const Scene& scene, const EnvironmentMap& environment, RenderSettings settings) {
    double fastest = 0;
    settings.threads = 1;
    for (settings.seed = 1; settings.seed <= seeds; ++settings.seed) {
        const Clock::time_point start = Clock::now();
        render(scene, environment, Sobolev(), settings);
        const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
        fastest = settings.seed == 1 ? seconds : std::min(fastest, seconds);
    }
    return fastest;
}

// The rules are made once whatever the size: their time, that of a picture of one pixel, is told from the pixels' time.
double seconds_per_megapixel(const Scene& scene, const EnvironmentMap& environment, RenderSettings settings) {
    const double whole = fastest_render(scene, environment, settings);
    const double pixels = object_pixels(scene, settings.width, settings.height);
    settings.width = settings.height = 1;
    const double rules = fastest_render(scene, environment, settings);
    return rules + 1e6 * (whole - rules) / pixels;
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
    return list;
}

}  // namespace

std::vector<PictureCost> picture_costs(const EnvironmentMap& environment, int size, bool timed) {
    const Scene scene = sphere_scene();
    const auto sized = [&](RenderSettings settings, std::size_t samples) {
        settings.samples = samples;
        settings.width = settings.height = size;
        settings.threads = std::max(1u, std::thread::hardware_concurrency());
        return settings;
    };
    RenderSettings dense;
    dense.method = Method::mc;
    dense.placement = Placement::fibonacci;
    const Image truth = render(scene, environment, Sobolev(), sized(dense, 20000));

    std::vector<PictureCost> rows;
    for (const RenderSettings& compared : compared_settings())
        for (const std::size_t samples : {10u, 20u, 40u, 80u, 160u}) {
            RenderSettings settings = sized(compared, samples);
            std::vector<Image> images;
            for (settings.seed = 1; settings.seed <= seeds; ++settings.seed)
                images.push_back(render(scene, environment, Sobolev(), settings));
            const ImageError error = image_error(scene, images, truth);
            rows.push_back({settings, error.rmse, error.correlation, error.brightness,
                            timed ? seconds_per_megapixel(scene, environment, settings) : 0});
        }
    return rows;
}
