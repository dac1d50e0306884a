#include "experiments/picture_cost.h"
#include "experiments/reports.h"
#include "light/texels_on_sphere.h"
#include "quadrature/gaussian_process.h"
#include "scene/known_light.h"

#include <numeric>

namespace bmc {
// z by its definition: 2 pi times the mean of k over 50,000 random directions.
static std::vector<double> z_by_sum(const Covariance& covariance, const std::vector<Vec3>& directions) {
    Random random(1, 0);
    std::vector<double> z(directions.size());
    for (const Vec3& omega : random_directions(50000, random))
        for (std::size_t j = 0; j < z.size(); ++j)
            z[j] += 2 * portable::pi / 50000 * covariance.k(squared_distance(omega, directions[j]));
    return z;
}

// The seconds, measured here, of each step from drawing n directions to their weights (Sobolev 3/2, noise 0.01): draw,
// Q, factor, z, weights. It does without the last two: the inverse of Q, and z by 50,000 random directions.
static std::vector<double> rule_seconds(std::size_t n) {
    const Sobolev covariance;
    const double noise = ModelSettings().noise;
    Random random(1, n);
    const GaussianProcess process(covariance, noise, random_directions(n, random));
    const Matrix q = covariance_matrix(covariance, noise, process.directions);
    volatile double sink = 0;  // keeps the results, so that no step is optimised away
    const auto time = [&](auto step) { return time_call([&] { sink = step(); }); };
    return {time([&] { return random_directions(n, random).back().x; }),
            time([&] { return covariance_matrix(covariance, noise, process.directions)(0, 0); }),
            time([&] { return Cholesky(q).upper(0, 0); }),
            time([&] { return z_of(covariance, process.directions).back(); }),
            time([&] { return process.cholesky.solve(process.z).back(); }),
            time([&] { return process.inverse_covariance()(0, 0); }),
            time([&] { return z_by_sum(covariance, process.directions).back(); })};
}

// The answer to assignment 3.3.1: what a rule for every pixel costs, and why.
static std::string rule_costs() {
    std::string text =
        R"(# What a rule costs, measured here: microseconds of each step. It needs neither the inverse of Q, whose
# factor gives the weights, nor z from 50,000 random directions, which has a closed form.
# samples       draw          Q     factor          z    weights    inverse     z50000
)";
    const RenderSettings usual;
    double usual_seconds = 0, sum_seconds = 0;  // of all steps, and of z by the sum
    for (const std::size_t n : {10u, 20u, 40u, 100u, 200u, 500u}) {
        const std::vector<double> seconds = rule_seconds(n);
        if (n == usual.samples) {
            usual_seconds = std::accumulate(seconds.begin(), seconds.end() - 2, 0.0);
            sum_seconds = seconds.back();
        }
        text += formatted("%9zu", n);
        for (const double step_seconds : seconds) text += formatted(" %10.3g", 1e6 * step_seconds);
        text += '\n';
    }
    double pixels = 0;
    for_each_hit(sphere_scene, {usual.width, usual.height}, [&](int, int, const Hit&) { ++pixels; });
    return text +
           formatted(
               R"(# A picture of %d x %d shows objects in %.0f pixels. A rule of %zu samples for each of them takes
# %.2g seconds. From 50,000 random directions, z alone would take %.2g minutes.


)",
               usual.width, usual.height, pixels, usual.samples, pixels * usual_seconds, pixels * sum_seconds / 60);
}

// By rays to 65536 points of equal light.
static Image true_picture(const CostSettings& costs, const EnvironmentMap& map) {
    const std::vector<Lamp> lamps = points_of_light(map, 0, 1 << 16);
    return render(map, row_settings(costs, {}, 1), [&](const Hit& hit, int, int) {
        Colour sum;
        for (const auto& [direction, light] : lamps)
            if (!is_shadowed(sphere_scene, hit, direction)) sum += std::max(0.0, dot(hit.normal, direction)) * light;
        return 1 / portable::pi * (hit.albedo * sum);
    });
}

static std::string tradeoff_table(const CostSettings& costs, const std::string& name, const EnvironmentMap& light) {
    const Image truth = true_picture(costs, light);
    Statistics mean;
    for_each_hit(sphere_scene, {costs.size, costs.size},
                 [&](int x, int y, const Hit&) { mean.add(brightness(truth(x, y)) / 3); });
    std::vector<PictureCost> compared = compared_pictures(light);
    for (const PictureCost& picture : known_light_pictures(light)) compared.push_back(picture);
    return formatted("# What a picture costs: the sphere scene, %d x %d pixels, under %s. The mean radiance is %.4g",
                     costs.size, costs.size, name.c_str(), mean.mean) +
           R"(.
# Against rays to 65,536 points of equal light, over 4 to 64 seeds. rmse: linear, over the pixels that show an
# object, with its standard error; correlation: of the errors of neighbouring pixels, less their mean; brightness:
# root mean square of the mean's relative error; mc_samples: samples with which mc has this rmse; known: what is
# known of the integrand. Where times are measured, here: seconds for a million pixels of objects on one processor;
# efficiency, 1 / (rmse^2 seconds), is that relative to mc. mis: half of the directions in proportion to the light;
# mis-ratio: that sum over itself without shadows, times the light without shadows.
)" + measured_table(costs, compared, truth);
}

std::string tradeoff_report(Arguments& arguments) {
    const CostSettings costs = taken_costs(arguments);
    return (costs.untimed ? "" : rule_costs()) + picture_report(costs, tradeoff_table);
}
}  // namespace bmc
