// Times the parts of a picture, and one by one what README says of them. Absolute times vary with the machine; the
// ratios to plain versions of the same loops, in the same run, hardly do. Not a test: it prints other numbers each run.
#include "numerics/portable_math.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "experiments/picture_cost.h"
#include "experiments/picture_error.h"
#include "light/desert.h"
#include "quadrature/gaussian_process.h"

using namespace bmc;

namespace {

volatile double sink;  // what is timed ends here, so that it is not optimised away

double rays_of(const PictureSettings& settings) {
    return object_pixels(sphere_scene(), {settings.width, settings.height}) * static_cast<double>(settings.samples);
}

PictureSettings square(int size, std::size_t samples, unsigned threads = 1) {
    PictureSettings settings;
    settings.width = settings.height = size;
    settings.samples = samples;
    settings.threads = threads;
    return settings;
}

double render_seconds(const EnvironmentMap& light, const PictureSettings& settings) {
    return seconds_of([&] { sink = render(sphere_scene(), light, settings)(0, 0).x; });
}

// The rules are made once, whatever the size: a picture of one pixel tells what they take.
double pixel_seconds(const EnvironmentMap& light, const PictureSettings& settings) {
    return render_seconds(light, settings) - render_seconds(light, square(1, settings.samples));
}

// The pool method's loop as one would first write it: a direction at a time, angles by libm.
Color plain_reflected_light(const Scene& scene, const Hit& hit, const QuadratureRule& rule, const Frame& frame,
                            const EnvironmentMap& environment) {
    Color sum;
    for (std::size_t i = 0; i < rule.weights.size(); ++i) {
        const Vec3 direction = frame.to_world(rule.directions[i]);
        if (intersect(scene, {hit.point + 1e-9 * hit.normal, direction})) continue;
        const double u = (1 + std::atan2(direction.x, -direction.z) / portable::pi) / 2;
        const double v = std::acos(std::clamp(direction.y, -1.0, 1.0)) / portable::pi;
        const int column = static_cast<int>(u * (environment.width() - 1)),
                  row = static_cast<int>(v * (environment.height() - 1));
        sum += (rule.weights[i] * dot(direction, hit.normal)) * environment.texel(row * environment.width() + column);
    }
    return sum;
}

double plain_seconds(const EnvironmentMap& environment, const PictureSettings& settings) {
    Random random(1, 0);
    const QuadratureRule rule = bayesian_rule(Sobolev(), 0.01, uniform_directions(settings.samples, random));
    return seconds_of([&] {
        Color sum;
        for_each_hit(sphere_scene(), {settings.width, settings.height}, [&](int, int, const Hit& hit) {
            const Frame frame = Frame(hit.normal).rotated(random.uniform());
            sum += plain_reflected_light(sphere_scene(), hit, rule, frame, environment);
        });
        sink = sum.x;
    });
}

void bench_rendering() {
    const EnvironmentMap light = load_environment();
    const PictureSettings settings = square(500, 40);
    const Image image = render(sphere_scene(), light, settings);
    std::printf("milliseconds: light %.2f, its averages %.2f, rules %.2f, PPM %.2f\n",
                1e3 * seconds_of([] { sink = load_environment().texels()[0]; }),
                1e3 * seconds_of([&] {
                    sink = PrefilteredEnvironment(light).irradiance({0, 1, 0}).x;
                }),
                1e3 * render_seconds(light, square(1, settings.samples)),
                1e3 * seconds_of([&] { sink = static_cast<double>(to_ppm(image).size()); }));
    for (const unsigned threads : {1u, 2u}) {
        PictureSettings direct = square(500, 40, threads);
        direct.method = Method::direct;
        std::printf("%u threads: the pixels of pool %.1f ms, the picture of direct %.2f s\n", threads,
                    1e3 * pixel_seconds(light, square(500, 40, threads)), render_seconds(light, direct));
    }
    for (const std::size_t samples : {10u, 40u, 100u, 1000u}) {
        const PictureSettings each = square(250, samples);
        std::printf("%4zu samples: %.2f ns a ray, %.2f as one would first write it\n", samples,
                    1e9 * pixel_seconds(light, each) / rays_of(each), 1e9 * plain_seconds(light, each) / rays_of(each));
    }
}

void bench_cholesky() {
    for (const std::size_t n : {40u, 100u, 1000u}) {
        Random random(1, n);
        const std::vector<Vec3> directions = uniform_directions(n, random);
        const Matrix q = symmetric(covariance_matrix(Sobolev(), 0.01, directions));
        std::printf("%4zu x %zu, microseconds: factor %.2f, and the inverse %.2f\n", n, n,
                    1e6 * seconds_of([&] { sink = Cholesky(q).upper()(0, 0); }),
                    1e6 * seconds_of([&] { sink = Cholesky(q).inverse()(0, 0); }));
    }
}

}  // namespace

int main() {
    bench_rendering();
    bench_cholesky();
}
