// Times the two hot paths against plain versions of the same loops, in one run: absolute times vary with the machine,
// the ratios hardly do. Not a test: what it prints differs from run to run.
#include "numerics/portable_math.h"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "experiments/picture_cost.h"
#include "experiments/picture_error.h"
#include "quadrature/gaussian_process.h"
#include "scene/desert.h"

using namespace bmc;

#ifdef COMPARE_LAPACK
extern "C" {
void dpotrf_(const char* triangle, const int* n, double* a, const int* stride, int* info);
void dpotri_(const char* triangle, const int* n, double* a, const int* stride, int* info);
}
#endif

namespace {

const Sobolev sobolev;
volatile double sink;  // what is timed ends here, so that it is not optimised away

double rays_of(const PictureSettings& settings) {
    return object_pixels(sphere_scene(), {settings.width, settings.height}) * static_cast<double>(settings.samples);
}

PictureSettings square(int size, std::size_t samples, unsigned threads) {
    PictureSettings settings;
    settings.width = settings.height = size;
    settings.samples = samples;
    settings.threads = threads;
    return settings;
}

double render_seconds(const EnvironmentLight& light, const PictureSettings& settings) {
    return seconds_of([&] { sink = picture(sphere_scene(), light, settings)(0, 0).x; });
}

// The rules are made once, whatever the size: a picture of one pixel tells what they take.
double ray_seconds(const EnvironmentLight& light, const PictureSettings& settings) {
    const double rules = render_seconds(light, square(1, settings.samples, 1));
    return (render_seconds(light, settings) - rules) / rays_of(settings);
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
        const float* texel = environment.texels() + 3 * (row * environment.width() + column);
        sum = sum + (rule.weights[i] * dot(direction, hit.normal)) * Color{texel[0], texel[1], texel[2]};
    }
    return sum;
}

double plain_render_seconds(const EnvironmentMap& environment, const PictureSettings& settings) {
    Random random(1, 0);
    const QuadratureRule rule = bayesian_rule(sobolev, 0.01, uniform_directions(settings.samples, random));
    const Camera camera{settings.width, settings.height};
    return seconds_of([&] {
        Color sum;
        for (int y = 0; y < settings.height; ++y)
            for (int x = 0; x < settings.width; ++x)
                if (const auto hit = intersect(sphere_scene(), camera.ray(x, y)))
                    sum = sum + plain_reflected_light(sphere_scene(), *hit, rule,
                                                      Frame(hit->normal).rotated(random.uniform()), environment);
        sink = sum.x;
    });
}

void bench_parts() {
    const EnvironmentMap environment = load_environment();
    const PictureSettings settings = square(500, 40, 1);
    const Image image = render(sphere_scene(), environment, settings);
    std::printf("# ./renderer --threads 1, milliseconds: light %.2f, rules %.2f, pixels %.2f, PPM %.2f\n",
                1e3 * seconds_of([] { sink = load_environment().texels()[0]; }),
                1e3 * render_seconds({environment}, square(1, settings.samples, 1)),
                1e3 * ray_seconds({environment}, settings) * rays_of(settings),
                1e3 * seconds_of([&] { sink = static_cast<double>(to_ppm(image).size()); }));
}

void bench_rendering() {
    const EnvironmentMap environment = load_environment();
    std::printf(
        "\n# a secondary ray of method pool, the rules made\n# size samples threads ms/picture   ns/ray  MiB at "
        "most\n");
    const auto row = [&](int size, std::size_t samples, unsigned threads) {
        const PictureSettings settings = square(size, samples, threads);
        const double seconds = ray_seconds({environment}, settings);
        rusage usage;
        getrusage(RUSAGE_SELF, &usage);
        std::printf("%6d %7zu %7u %10.2f %8.2f %12ld\n", size, samples, threads, 1e3 * seconds * rays_of(settings),
                    1e9 * seconds, usage.ru_maxrss / 1024);
    };
    for (const int size : {125, 250, 500, 1000, 2000}) row(size, 40, 1);
    for (const std::size_t samples : {10u, 100u, 400u, 1000u}) row(250, samples, 1);
    for (const unsigned threads : {1u, 2u, 4u}) row(500, 40, threads);
    const PictureSettings plain = square(250, 40, 1);
    std::printf("# as one would first write it: %.2f ns/ray\n",
                1e9 * plain_render_seconds(environment, plain) / rays_of(plain));
    for (const unsigned threads : {1u, 2u}) {
        PictureSettings direct = square(500, 40, threads);
        direct.method = Method::direct;
        std::printf("# method direct, 500x500, 40 samples, %u threads: %.2f s\n", threads,
                    seconds_of([&] { sink = render(sphere_scene(), environment, direct)(0, 0).x; }));
    }
}

// A ray where the cosine is known and where the light is, on the directions that suit both; the two in turn, since the
// machine's speed drifts.
void bench_known_light() {
    const EnvironmentMap environment = load_environment();
    const EnvironmentLight light = prefilter(environment);
    std::size_t floats = 3 * 257 * 129;  // of the irradiance
    for (const LightTable& table : light.prefiltered->tables())
        if (table.rgb != environment.texels()) floats += 3 * static_cast<std::size_t>(table.columns * table.rows);
    std::printf("\n# averages of a known light: %.1f ms, %.1f MiB\n",
                1e3 * seconds_of([&] {
                    sink = PrefilteredEnvironment(environment).irradiance({0, 1, 0}).x;
                }),
                static_cast<double>(floats * sizeof(float)) / (1 << 20));
    for (const std::size_t samples : {10u, 40u, 160u}) {
        PictureSettings settings = square(250, samples, 1);
        settings.placement = Placement::cosine_fibonacci;
        std::vector<double> cosine, known;
        for (int run = 0; run < 7; ++run) {
            settings.set_known(Known::cosine);
            cosine.push_back(ray_seconds(light, settings));
            settings.set_known(Known::light);
            known.push_back(ray_seconds(light, settings));
        }
        const double least = *std::min_element(cosine.begin(), cosine.end());
        const double least_known = *std::min_element(known.begin(), known.end());
        std::printf("# %zu samples: %.2f ns/ray with the cosine known, %.2f with the light, ratio %.2f\n", samples,
                    1e9 * least, 1e9 * least_known, least_known / least);
    }
}

// The textbook's loop: an inner product for every element.
void textbook_factor(Matrix& a) {
    for (std::size_t j = 0; j < a.rows(); ++j)
        for (std::size_t i = j; i < a.rows(); ++i) {
            double sum = a(i, j);
            for (std::size_t k = 0; k < j; ++k) sum -= a(i, k) * a(j, k);
            a(i, j) = i == j ? std::sqrt(sum) : sum / a(j, j);
        }
}

void bench_cholesky() {
    std::printf(
        "\n# Cholesky, microseconds; GFLOP/s of the factor, n^3 / 3 operations\n"
        "# size     factor GFLOP/s    textbook  inverse  lapack_factor lapack_inverse\n");
    for (const std::size_t n : {10u, 20u, 40u, 100u, 200u, 400u, 1000u, 2000u}) {
        Random random(1, n);
        const std::vector<Vec3> directions = uniform_directions(n, random);
        const Matrix q = symmetric(covariance_matrix(sobolev, 0.01, directions));
        const double size = static_cast<double>(n);
        const double factor = seconds_of([&] { sink = Cholesky(q).upper()(0, 0); });
        const double inverse = seconds_of([&] { sink = Cholesky(q).inverse()(0, 0); });
        const double textbook = seconds_of([&] {
            Matrix a = q;
            textbook_factor(a);
            sink = a(0, 0);
        });
        std::printf("%6zu %10.2f %7.1f %11.2f %8.2f", n, 1e6 * factor, 1e-9 * size * size * size / 3 / factor,
                    1e6 * textbook, 1e6 * inverse);
#ifdef COMPARE_LAPACK
        const int order = static_cast<int>(n);
        const auto lapack = [&](bool invert) {
            return seconds_of([&] {
                Matrix a = q;
                int info = 0;
                dpotrf_("L", &order, a.row(0), &order, &info);
                if (invert) dpotri_("L", &order, a.row(0), &order, &info);
                for (std::size_t i = 0; invert && i < n; ++i)
                    for (std::size_t j = 0; j < i; ++j) a(i, j) = a(j, i);
                sink = a(0, 0);
            });
        };
        std::printf(" %12.2f %12.2f", 1e6 * lapack(false), 1e6 * lapack(true));
#endif
        std::printf("\n");
    }
    std::printf("\n# one Gaussian process from directions to weights, 40 samples: %.2f microseconds\n",
                1e6 * seconds_of([] {
                    Random random(1, 0);
                    sink = bayesian_rule(sobolev, 0.01, uniform_directions(40, random)).weights[0];
                }));
}

}  // namespace

int main() {
    bench_parts();
    bench_rendering();
    bench_known_light();
    bench_cholesky();
}
