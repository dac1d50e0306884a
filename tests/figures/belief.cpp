// What a Gaussian process believes of the light that arrives at a point of the rectangle: on stdout a picture of four
// discs side by side, on stderr what is written below each. A disc is the hemisphere above the point, as a fish-eye
// sees it, in Lambert's equal-area projection: the sum of its pixels is an integral with respect to solid angle.
#include "experiments/integrands.h"
#include "light/desert.h"
#include "scene/image.h"
#include "scene/scene.h"

#include <cstdio>
#include <numeric>

using namespace bmc;

namespace {

constexpr int disc = 200, subpixels = 3;  // pixels of a side; a pixel's on a side
constexpr double error_scale = 2.5;       // where errors are shown, a luminance of 0.4 is white
constexpr double dot_radius = 0.018;      // of a sample, in radii of the disc
const Color white{1, 1, 1}, ink = srgb_decoded(118.0 / 255) * white;

const Scene scene = sphere_scene();
const Hit hit = *intersect(scene, Camera{500, 500}.ray(140, 470));
const EnvironmentMap environment = load_environment();

Color light(Vec3 direction) {
    const Vec3 w = Frame(hit.normal).to_world(direction);
    return is_shadowed(scene, hit, w) ? Color{} : environment.interpolated_radiance(w);
}

const Integrand integrand{"", "", [](Vec3 w) { return dot(luminance, light(w)); }, 0};
Random stream(7, 0);
const Sobolev covariance;
const GaussianProcess& process() {
    static const GaussianProcess made(covariance, 0.01, uniform_directions(40, stream));
    return made;
}
const std::vector<double>& values() {
    static const std::vector<double> made = sample(integrand, process().directions());
    return made;
}

// Posterior mean k^T Q^-1 Y, and the standard deviation of the luminance, a sqrt(k(w, w) - k^T Q^-1 k); k holds the
// covariances of w with the samples.
struct Belief {
    Color mean;
    double deviation;
};
Belief belief(Vec3 w) {
    std::vector<double> k;
    for (const Vec3 direction : process().directions()) k.push_back(covariance(squared_distance(w, direction)));
    const std::vector<double> weights = process().cholesky().solve(k);
    Color mean;
    for (std::size_t j = 0; j < k.size(); ++j) mean += weights[j] * light(process().directions()[j]);
    const double explained = std::inner_product(k.begin(), k.end(), weights.begin(), 0.0);
    return {mean, process().amplitude(values()) * std::sqrt(covariance(0) - explained)};
}

Color light_and_samples(Vec3 w, double u, double v) {
    for (const Vec3 direction : process().directions()) {
        const double s = std::sqrt(1 + direction.y), distance = length({v + direction.x / s, u + direction.z / s, 0});
        if (distance < 1.7 * dot_radius) return distance < dot_radius ? white : Color{};
    }
    return light(w);
}

// At (u, v) of a disc of radius 1, v downwards. Archimedes: y is 1 - u^2 - v^2. Who looks up with -z ahead has x on the
// left; these are the -x and -z of the point's frame.
Color color_at(int number, double u, double v) {
    const double y = 1 - u * u - v * v, s = std::sqrt(1 + y);
    if (y <= 0) return ink;
    const Vec3 w{-s * v, y, -s * u};
    if (number == 0) return light_and_samples(w, u, v);
    const auto [mean, deviation] = belief(w);
    if (number == 1) return mean;
    return error_scale * (number == 2 ? deviation : std::fabs(dot(luminance, mean - light(w)))) * white;
}

Color pixel(int x, int y) {
    Color sum;
    for (int i = 0; i < subpixels * subpixels; ++i) {
        const double u = x % disc + (i % subpixels + 0.5) / subpixels, v = y + (i / subpixels + 0.5) / subpixels;
        sum += color_at(x / disc, 2 * u / disc - 1, 2 * v / disc - 1);
    }
    return 1.0 / (subpixels * subpixels) * sum;
}

}  // namespace

int main() try {
    const std::string picture = to_ppm(image_of(4 * disc, disc, pixel));
    std::fwrite(picture.data(), 1, picture.size(), stdout);
    const double truth = dense_quadrature(integrand), estimate = process().integral(values());
    std::fprintf(stderr, "integral %.2f\nestimate %.2f\nstandard error %.2f\nerror %.2f\n", truth, estimate,
                 process().standard_error(values()), std::fabs(estimate - truth));
} catch (const std::exception& error) {
    std::fprintf(stderr, "belief: %s\n", error.what());
    return 1;
}
