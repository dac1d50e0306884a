#include "experiments/belief.h"

#include "base/parallel.h"
#include "base/statistics.h"

#include "experiments/integrands.h"
#include "scene/image.h"
#include "scene/scene.h"

#include <numeric>

namespace bmc {
constexpr int disc = 200, subpixels = 3;  // pixels on a side of a disc; subpixels on a side of a pixel
constexpr double error_scale = 2.5;       // in the last two discs a luminance of 0.4 is white
constexpr double dot_radius = 0.018;      // of a sample's dot, in radii of the disc
constexpr double least_seen = 0.3;        // of a light's root mean square; with less, nine in ten bars are false
constexpr Color white{1, 1, 1}, grey{0.18, 0.18, 0.18};

// Q^-1 Y of colours Y.
static std::vector<Color> solved(const Cholesky& cholesky, std::vector<Color> colors) {
    for (double Vec3::*const channel : {&Vec3::x, &Vec3::y, &Vec3::z}) {
        std::vector<double> values;
        for (const Color& color : colors) values.push_back(color.*channel);
        values = cholesky.solve(std::move(values));
        for (std::size_t j = 0; j < values.size(); ++j) colors[j].*channel = values[j];
    }
    return colors;
}

// all: the root mean square of the light, where values are its samples. An error bar does not know what none has met.
static void print_estimate(const GaussianProcess& process, const std::vector<double>& values, double truth,
                           double all) {
    const double error = process.standard_error(values);
    print_note(formatted("estimate %.5g, standard error %s, truth %.5g", process.integral(values),
                         error > 0 ? formatted("%.3g", error).c_str() : "unknown", truth));
    RootMeanSquare seen;
    for (const double value : values) seen.add(value);
    if (seen.value() < least_seen * all)
        print_note(
            formatted("note: the samples have seen %.2g %% of this light (root mean square), and the standard "
                      "error knows of no more",
                      100 * seen.value() / all));
}

void Belief::add_options(Options& options) {
    options.add("samples", "N", "directions of the process (default 40)", samples, 1, 400);
    options.add("environment", "FILE", environment_help, environment);
    add_model_options(options, settings);
}

std::string Belief::report() const {
    const EnvironmentMap map = load_environment(environment, processors());
    const auto covariance = settings.make_covariance();
    Random random(settings.seed, 0);
    const GaussianProcess process(*covariance, settings.noise,
                                  place_directions(settings.placement, samples, random).directions);
    const Hit hit = *intersect(sphere_scene, Camera{500, 500}.ray(140, 470));  // the sphere hides a part of its sky
    const auto light = [&, frame = Frame(hit.normal)](Vec3 w) {
        const Vec3 direction = frame.to_world(w);
        return is_shadowed(sphere_scene, hit, direction) ? Color{} : map.bilinear_radiance(direction);
    };
    const auto incident = [&](Vec3 w) { return luminance(light(w)) * known_part(settings.known, w); };
    const std::vector<double> values = evaluate(incident, process.directions, settings.known);
    const auto square = [&](Vec3 w) { return luminance(light(w)) * incident(w); };
    print_estimate(process, values, reference_integral(incident),
                   std::sqrt(reference_integral(square) / known_integral(settings.known)));

    std::vector<Color> seen;
    for (const Vec3& direction : process.directions) seen.push_back(light(direction));
    const std::vector<Color> coefficients = solved(process.cholesky, seen);
    const double amplitude = process.amplitude(values);
    const auto covariances = [&](Vec3 w) {
        std::vector<double> k;
        for (const Vec3& direction : process.directions) k.push_back(covariance->k(squared_distance(w, direction)));
        return k;
    };
    const auto mean = [&](Vec3 w) {  // k^T Q^-1 Y
        const std::vector<double> k = covariances(w);
        Color sum;
        for (std::size_t j = 0; j < k.size(); ++j) sum += k[j] * coefficients[j];
        return sum;
    };
    const auto deviation = [&](Vec3 w) {  // a sqrt(k(w, w) - k^T Q^-1 k); where L y = k, k^T Q^-1 k is |y|^2
        const std::vector<double> y = process.cholesky.forward_substitution(covariances(w));
        const double explained = std::inner_product(y.begin(), y.end(), y.begin(), 0.0);
        return amplitude * std::sqrt(std::fmax(covariance->k(0) - explained, 0));
    };
    const auto light_and_samples = [&](Vec3 w, double u, double v) {
        for (const Vec3& direction : process.directions) {
            const double s = std::sqrt(1 + direction.y);
            const double distance = length({v + direction.x / s, u + direction.z / s, 0});
            if (distance < 1.7 * dot_radius) return distance < dot_radius ? white : Color{};
        }
        return light(w);
    };
    // The colour at (u, v) of disc 0 to 3, of radius 1, v downwards. A disc is the hemisphere in Lambert's equal-area
    // projection: y is 1 - u^2 - v^2. Looking up with -z ahead, x is on the left.
    const auto color = [&](int number, double u, double v) {
        const double y = 1 - u * u - v * v, s = std::sqrt(1 + y);
        if (y <= 0) return grey;
        const Vec3 w{-s * v, y, -s * u};
        if (number == 0) return light_and_samples(w, u, v);
        if (number == 1) return mean(w);
        if (number == 2) return error_scale * deviation(w) * white;
        return error_scale * std::fabs(luminance(mean(w) - light(w))) * white;
    };
    Image image(4 * disc, disc);
    Progress progress(disc);
    for_each_row(disc, processors(), [&](int y) {
        for (int i = 0; i < subpixels * subpixels * image.width; ++i) {
            const int x = i / (subpixels * subpixels), part = i % (subpixels * subpixels);
            const double u = x % disc + (part % subpixels + 0.5) / subpixels,
                         v = y + (part / subpixels + 0.5) / subpixels;
            image(x, y) += 1.0 / (subpixels * subpixels) * color(x / disc, 2 * u / disc - 1, 2 * v / disc - 1);
        }
        progress.done();
    });
    return encode(image, Format::ppm);
}
}  // namespace bmc
