#include "base/progress.h"
#include "experiments/picture_cost.h"
#include "experiments/reports.h"
#include "known_light/known_light.h"
#include "quadrature/gaussian_process.h"

#include <numeric>

namespace bmc {
using portable::pi;

// z by its definition: 2 pi times the mean of k over 50,000 random directions.
static std::vector<double> z_by_sum(const Covariance& covariance, const std::vector<Vec3>& directions) {
    Random random(1, 0);
    std::vector<double> z(directions.size());
    for (const Vec3& omega : random_directions(50000, random))
        for (std::size_t j = 0; j < z.size(); ++j)
            z[j] += 2 * pi / 50000 * covariance.k(squared_distance(omega, directions[j]));
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
    const double pixels = pixels_of_objects({usual.width, usual.height});
    return text +
           formatted(
               R"(# A picture of %d x %d shows objects in %.0f pixels. A rule of %zu samples for each of them takes
# %.2g seconds. From 50,000 random directions, z alone would take %.2g minutes.


)",
               usual.width, usual.height, pixels, usual.samples, pixels * usual_seconds, pixels * sum_seconds / 60);
}

// What the methods know of a light: its map, points of equal light, and the tables for a number of samples.
struct Light {
    const EnvironmentMap& map;
    const std::vector<Lamp>& lamps;
    const KnownLight known;
};

// What renderers do with a light that they know: half of the samples are drawn in proportion to the light and
// stratified, the others are the directions of a rule, of density cos(theta) / pi. Each is weighted by the balance
// heuristic of multiple importance sampling (Veach & Guibas, "Optimally combining sampling techniques for Monte Carlo
// rendering", SIGGRAPH 1995). With the table of E(n), the sum is divided by itself without shadows and multiplied by
// E(n) (Heitz, Hill & McGuire, "Combining analytic direct illumination and stochastic shadows", I3D 2018).
static Shader mis_shader(const Light& light, bool as_ratio, RenderSettings settings) {
    const auto all = static_cast<double>(settings.samples), points = static_cast<double>(light.lamps.size());
    settings.samples = (settings.samples + 1) / 2;
    return [=, &light, rules = PixelRules(settings)](const Hit& hit, int x, int y) {
        Random random = pixel_stream(settings, x, y);
        const OrientedRule oriented = rules.rule_for(hit.normal, random);
        std::vector<Vec3> directions = oriented.rule->directions;
        for (Vec3& direction : directions) direction = oriented.frame.to_world(direction);
        const double by_cosine = static_cast<double>(directions.size()), by_light = all - by_cosine;
        for (double j = 0; j < by_light; ++j)
            directions.push_back(light.lamps[std::size_t((j + random.uniform()) / by_light * points)].direction);
        Arriving sum;
        for (const Vec3& direction : directions) {
            const double cosine = dot(hit.normal, direction);
            const Colour radiance = light.map.radiance(direction);
            const double drawn = by_light * channel_sum(radiance) / (points * channel_sum(light.lamps[0].light));
            if (cosine > 0) sum.add(hit, {direction, 1 / (drawn + by_cosine * cosine / pi) * radiance});
        }
        if (!as_ratio) return 1 / pi * (hit.albedo * sum.visible);
        return 1 / pi * (hit.albedo * fraction(sum.visible, sum.all) * light.known.irradiance(hit.normal));
    };
}

// The methods that are compared: classic Monte Carlo first, and in the end those that know the light.
static std::vector<PictureMethod> compared_methods(const Light& light, RenderSettings s) {
    std::vector<PictureMethod> methods;
    const auto compare = [&](Method method, std::size_t pool, PointSet set, Density density) {
        s.method = method;
        s.pool = pool;
        s.placement = {set, density};
        methods.push_back({name_of(method, method_names), name_of(s.known_or_usual(), known_names), s,
                           [&](const auto& each) { return environment_shader(light.map, PixelRules(each)); }});
    };
    compare(Method::mc, 1, PointSet::random, Density::uniform);
    compare(Method::mc, 1, PointSet::random, Density::cosine);
    for (const Method method : {Method::direct, Method::single, Method::rotated})
        compare(method, 1, PointSet::random, Density::uniform);
    for (const std::size_t pool : {5u, 20u}) compare(Method::pool, pool, PointSet::random, Density::uniform);
    compare(Method::pool, 20, PointSet::random, Density::cosine);
    for (const PointSet set : {PointSet::stratified, PointSet::fibonacci, PointSet::optimised}) {
        compare(Method::mc, 1, set, Density::cosine);
        compare(Method::pool, set == PointSet::stratified ? 20 : 1, set, Density::cosine);
    }
    s.method = Method::mc;
    methods.push_back({"mis", "light", s, [&](const auto& each) { return mis_shader(light, false, each); }});
    methods.push_back({"mis-ratio", "light", s, [&](const auto& each) { return mis_shader(light, true, each); }});
    s.method = Method::pool;
    methods.push_back({"pool", "light", s, [&](const auto& each) { return known_light_shader(light.known, each); }});
    return methods;
}

// The settings of tradeoff.
struct Asked {
    std::string environment = {};  // empty: the built-in lights
    int size = 64;
    std::uint64_t seed = 1;  // picture i of seed k has the seed 1000 (k - 1) + i, i from 1
    bool untimed = false;
    std::vector<std::size_t> sample_counts{10, 40};
};

static std::string tradeoff_table(const Asked& asked, const std::string& name) {
    const EnvironmentMap map = load_environment(name);
    const std::vector<Lamp> lamps = points_of_light(map, 0, 1 << 15);
    RenderSettings settings;
    settings.width = settings.height = asked.size;
    settings.seed = 1000 * (asked.seed - 1);
    const Image truth = render(map, settings, [&](const Hit& hit, int, int) {
        Arriving sum;
        for (const Lamp& lamp : lamps) sum.add(hit, lamp);
        return 1 / pi * (hit.albedo * sum.visible);
    });
    Statistics mean;
    for_each_hit({asked.size, asked.size}, [&](int x, int y, const Hit&) { mean.add(channel_sum(truth(x, y)) / 3); });
    if (mean.mean == 0)
        throw std::runtime_error("the environment lights no object, so there is no error to compare; take another");
    std::vector<PictureRow> rows;
    for (const std::size_t n : asked.sample_counts) {
        settings.samples = n;
        const Light light{map, lamps, known_light(map, n, settings.threads)};
        const std::vector<PictureMethod> methods = compared_methods(light, settings);
        Progress progress(formatted("methods with %zu samples", n), methods.size());
        for (const PictureMethod& method : methods) {
            rows.push_back(picture_row(method, truth, !asked.untimed));
            progress.done();
        }
    }
    return formatted("# What a picture costs: the sphere scene, %d x %d pixels, under %s. The mean radiance is %.4g",
                     asked.size, asked.size, name.c_str(), mean.mean) +
           R"(.
# Against rays to 32,768 points of equal light, over 4 to 64 seeds. rmse: linear, over the pixels that show an
# object, with its standard error; correlation: of the errors of neighbouring pixels, less their mean; brightness:
# root mean square of the mean's relative error; mc_samples: samples with which mc has this rmse; known: what is
# known of the integrand. Where times are measured, here: seconds for a million pixels of objects on one processor,
# without the tables of a known light, which all pictures share; efficiency, 1 / (rmse^2 seconds), is that relative to
# mc. mis: half of the directions in proportion to the light; mis-ratio: that sum over itself without shadows, times
# the light without shadows.
)" + picture_table(rows, !asked.untimed);
}

std::string tradeoff_report(Arguments& arguments) {
    Asked asked;
    arguments.add("environment", "FILE", "one light, as for the renderer (default: each built-in light)",
                  asked.environment);
    arguments.add("size", "W", "size of the pictures: W x W pixels", asked.size, 2, 1024);
    arguments.add("seed", "K", "seed of the random numbers", asked.seed, 0, UINT64_MAX);
    arguments.add("no-times", "leave out measured times, which differ from run to run", asked.untimed);
    add_sample_list(arguments, asked.sample_counts);
    arguments.take();
    std::string text = asked.untimed ? "" : rule_costs();
    const auto names = asked.environment.empty() ? light_names() : std::vector{asked.environment};
    for (const std::string& name : names) text += (&name == &names[0] ? "" : "\n\n") + tradeoff_table(asked, name);
    return text;
}
}  // namespace bmc
