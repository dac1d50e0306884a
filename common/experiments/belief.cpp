#include "experiments/belief.h"

#include "experiments/integrands.h"
#include "numerics/parallel.h"
#include "numerics/progress.h"
#include "scene/image.h"
#include "scene/scene.h"

#include <algorithm>
#include <numeric>
#include <thread>

namespace bmc {
namespace {

constexpr int disc = 200, subpixels = 3;  // pixels on a side of a disc; subpixels on a side of a pixel
constexpr double error_scale = 2.5;       // in the last two discs a luminance of 0.4 is white
constexpr double dot_radius = 0.018;      // of a sample's dot, in radii of the disc
constexpr Color white{1, 1, 1}, grey{0.18, 0.18, 0.18};

// A point of the rectangle, the light above it, and what a process believes of that light.
class Sky {
public:
    Sky(const EnvironmentMap& map, const Covariance& covariance, const GaussianProcess& process)
        : map_(map), covariance_(covariance), process_(process) {
        std::vector<double> luminances;
        for (const Vec3& w : process.directions()) {
            samples_.push_back(light(w));
            luminances.push_back(dot(luminance, samples_.back()));
        }
        amplitude_ = process.amplitude(luminances);
        const auto solved = [&](double Vec3::*channel) {
            std::vector<double> values;
            for (const Color& sample : samples_) values.push_back(sample.*channel);
            return process.cholesky().solve(values);
        };
        const std::vector<double> x = solved(&Vec3::x), y = solved(&Vec3::y), z = solved(&Vec3::z);
        for (std::size_t j = 0; j < x.size(); ++j) coefficients_.push_back({x[j], y[j], z[j]});
    }

    Color light(Vec3 w) const {
        const Vec3 direction = Frame(hit_.normal).to_world(w);
        return is_shadowed(scene_, hit_, direction) ? Color{} : map_.bilinear_radiance(direction);
    }

    // The colour at (u, v) of disc 0 to 3, of radius 1, v downwards. A disc is the hemisphere in Lambert's equal-area
    // projection: y is 1 - u^2 - v^2. Looking up with -z ahead, x is on the left.
    Color color(int number, double u, double v) const {
        const double y = 1 - u * u - v * v, s = std::sqrt(1 + y);
        if (y <= 0) return grey;
        const Vec3 w{-s * v, y, -s * u};
        return number == 0 ? light_and_samples(w, u, v) : belief(number, w);
    }

private:
    Color light_and_samples(Vec3 w, double u, double v) const {
        for (const Vec3& direction : process_.directions()) {
            const double s = std::sqrt(1 + direction.y);
            const double distance = length({v + direction.x / s, u + direction.z / s, 0});
            if (distance < 1.7 * dot_radius) return distance < dot_radius ? white : Color{};
        }
        return light(w);
    }

    // The posterior mean k^T Q^-1 Y, the standard deviation a sqrt(k(w, w) - k^T Q^-1 k), or the error of the mean.
    // Where L y = k, k^T Q^-1 k is |y|^2.
    Color belief(int number, Vec3 w) const {
        std::vector<double> k;
        for (const Vec3& direction : process_.directions()) k.push_back(covariance_.k(squared_distance(w, direction)));
        if (number == 2) {
            const std::vector<double> y = process_.cholesky().forward_substitution(k);
            const double explained = std::inner_product(y.begin(), y.end(), y.begin(), 0.0);
            return error_scale * amplitude_ * std::sqrt(std::fmax(covariance_.k(0) - explained, 0)) * white;
        }
        Color mean;
        for (std::size_t j = 0; j < k.size(); ++j) mean += k[j] * coefficients_[j];
        return number == 1 ? mean : error_scale * std::fabs(dot(luminance, mean - light(w))) * white;
    }

    const EnvironmentMap& map_;
    const Covariance& covariance_;
    const GaussianProcess& process_;
    const Scene scene_ = sphere_scene();
    const Hit hit_ = *intersect(scene_, Camera{500, 500}.ray(140, 470));  // the sphere hides a part of its sky
    std::vector<Color> samples_, coefficients_;                           // Y and Q^-1 Y
    double amplitude_;
};

}  // namespace

Options Belief::options() {
    return joined({Options{integer_option("samples", "N", "directions of the process (default 40)", samples, 400),
                           text_option("environment", "FILE", environment_help, environment)},
                   model_options(settings)});
}

std::string Belief::report() const {
    const unsigned threads = std::max(1u, std::thread::hardware_concurrency());
    const EnvironmentMap map = load_environment(environment, threads);
    const auto covariance = settings.make_covariance();
    Random random(settings.seed, 0);
    const GaussianProcess process(*covariance, settings.noise,
                                  place_directions(settings.placement, samples, random).directions);
    const Sky sky(map, *covariance, process);
    const auto value = [&](Vec3 w) { return dot(luminance, sky.light(w)) * known_part(settings.known, w); };
    const Integrand integrand{"", "", value, 0};
    const std::vector<double> values = evaluate(integrand, process.directions(), settings.known);
    print_note(formatted("estimate %.4f, standard error %.4f, truth %.4f", process.integral(values),
                         process.standard_error(values), reference_integral(integrand)));
    Image image(4 * disc, disc);
    Progress progress(disc);
    for_each_row(disc, threads, [&](int y) {
        for (int i = 0; i < subpixels * subpixels * image.width; ++i) {
            const int x = i / (subpixels * subpixels), part = i % (subpixels * subpixels);
            const double u = x % disc + (part % subpixels + 0.5) / subpixels,
                         v = y + (part / subpixels + 0.5) / subpixels;
            image(x, y) += 1.0 / (subpixels * subpixels) * sky.color(x / disc, 2 * u / disc - 1, 2 * v / disc - 1);
        }
        progress.done();
    });
    return encode(image, Format::ppm);
}
}  // namespace bmc
