#include "experiments/reports.h"

#include "base/progress.h"
#include "base/statistics.h"
#include "base/terminal.h"
#include "experiments/integrands.h"
#include "quadrature/gaussian_process.h"
#include "scene/image.h"
#include "scene/scene.h"

#include <numeric>

namespace bmc {
constexpr int disc = 200, subpixels = 3;  // pixels on a side of a disc; subpixels on a side of a pixel
constexpr double error_scale = 2.5;       // in the last two discs a luminance of 0.4 is white
constexpr double dot_radius = 0.018;      // of a sample's dot, in radii of the disc
constexpr Colour white{1, 1, 1}, grey{0.18, 0.18, 0.18};

// The light that arrives at a point of the rectangle. The sphere hides a part of its sky.
struct View {
    const EnvironmentMap map;
    const Hit hit = *intersect(sphere_scene, Camera{500, 500}.ray(140, 470));
    const Frame frame = Frame(hit.normal);

    Colour light(Vec3 omega) const {
        const Vec3 direction = frame.to_world(omega);
        return is_shadowed(sphere_scene, hit, direction) ? Colour{} : map.bilinear_radiance(direction);
    }
};

// What the process believes of this light after it has seen Y. k has the covariances of a direction omega with the
// samples.
struct Posterior {
    const Covariance& covariance;
    const GaussianProcess& process;
    const double amplitude;
    std::vector<Colour> coefficients;  // Q^-1 Y

    std::vector<double> covariances(Vec3 omega) const {
        std::vector<double> k;
        for (const Vec3& direction : process.directions) k.push_back(covariance.k(squared_distance(omega, direction)));
        return k;
    }

    Colour mean(Vec3 omega) const {  // k^T Q^-1 Y
        const std::vector<double> k = covariances(omega);
        Colour sum;
        for (std::size_t j = 0; j < k.size(); ++j) sum += k[j] * coefficients[j];
        return sum;
    }

    double deviation(Vec3 omega) const {  // a sqrt(k(omega, omega) - k^T Q^-1 k); where U^T y = k, k^T Q^-1 k is |y|^2
        const std::vector<double> y = process.cholesky.forward_substitution(covariances(omega));
        const double explained = std::inner_product(y.begin(), y.end(), y.begin(), 0.0);
        return amplitude * std::sqrt(std::fmax(covariance.k(0) - explained, 0));
    }
};

// The colour at (u, v) of disc 0 to 3, of radius 1, v downwards. A disc is the hemisphere in Lambert's equal-area
// projection: y is 1 - u^2 - v^2. Looking up with -z ahead, x is on the left.
static Colour disc_colour(int number, double u, double v, const View& view, const Posterior& posterior) {
    const double y = 1 - u * u - v * v, s = std::sqrt(1 + y);
    if (y <= 0) return grey;
    const Vec3 omega{-s * v, y, -s * u};
    if (number == 1) return posterior.mean(omega);
    if (number == 2) return error_scale * posterior.deviation(omega) * white;
    if (number == 3) return error_scale * std::fabs(luminance(posterior.mean(omega) - view.light(omega))) * white;
    for (const Vec3& direction : posterior.process.directions) {
        const double root = std::sqrt(1 + direction.y);
        const double distance = length({v + direction.x / root, u + direction.z / root, 0});
        if (distance < 1.7 * dot_radius) return distance < dot_radius ? white : Colour{};
    }
    return view.light(omega);
}

static Image discs(const View& view, const Posterior& posterior) {
    Image image(4 * disc, disc);
    Progress progress("discs", disc);
    for_each_row(disc, processors(), [&](int y) {
        for (int i = 0; i < subpixels * subpixels * image.width; ++i) {
            const int x = i / (subpixels * subpixels), part = i % (subpixels * subpixels);
            const double u = x % disc + (part % subpixels + 0.5) / subpixels,
                         v = y + (part / subpixels + 0.5) / subpixels;
            image(x, y) += 1.0 / (subpixels * subpixels) *
                           disc_colour(x / disc, 2 * u / disc - 1, 2 * v / disc - 1, view, posterior);
        }
        progress.done();
    });
    return image;
}

// all: the root mean square of the light. Where the samples have seen less than 0.3 of it, nine in ten bars are false.
static void print_estimate(const GaussianProcess& process, const std::vector<double>& seen, double truth, double all) {
    const double error = process.error_bar(seen);
    print_note(formatted("estimate %.5g, error bar %s, truth %.5g", process.integral(seen),
                         error > 0 ? formatted("%.3g", error).c_str() : "unknown", truth));
    RootMeanSquare size;
    for (const double value : seen) size.add(value);
    if (size.value() < 0.3 * all)
        print_note(formatted("note: the samples have seen %.2g %% of this light, and the error bar knows no more",
                             100 * size.value() / all));
}

// Four discs side by side show the light and the samples, the posterior mean, the posterior standard deviation, and the
// error of the mean.
std::string belief_discs(Arguments& arguments) {
    std::size_t samples = 40;
    std::string environment = built_in_lights[0];
    ModelSettings settings;
    arguments.add("samples", "N", "directions of the process", samples, 1, 400);
    arguments.add("environment", "FILE", environment_help(), environment);
    add_model_options(arguments, settings);
    arguments.take("belief.ppm");
    const View view{load_environment(environment, processors())};
    const auto covariance = settings.make_covariance();
    Random random(settings.seed, 0);
    const GaussianProcess process(*covariance, settings.noise, sampler_of(settings.placement, samples)(random));
    const auto incident = [&](Vec3 omega) { return luminance(view.light(omega)) * known_part(process.known, omega); };
    const auto square = [&](Vec3 omega) { return luminance(view.light(omega)) * incident(omega); };
    const std::vector<double> values = unknown_part(incident, process.directions, process.known);
    print_estimate(process, values, reference_integral(incident),
                   std::sqrt(reference_integral(square) / known_integral(process.known)));
    Posterior posterior{*covariance, process, process.amplitude(values), std::vector<Colour>(samples)};
    for (double Colour::*channel : {&Colour::x, &Colour::y, &Colour::z}) {
        std::vector<double> light;
        for (const Vec3& direction : process.directions) light.push_back(view.light(direction).*channel);
        light = process.cholesky.solve(std::move(light));
        for (std::size_t j = 0; j < samples; ++j) posterior.coefficients[j].*channel = light[j];
    }
    return encode(discs(view, posterior), Format::ppm);
}
}  // namespace bmc
