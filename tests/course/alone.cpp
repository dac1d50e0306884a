// alone TASK: what the functions of the task montecarlo, inverse, z or shade give by themselves, whatever becomes of
// the others. alone_integral and alone_rules do so for the tasks that need others, on stand-ins of these.
#include "quadrature/quadrature.h"
#include "scene/reflection.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <stdexcept>

using namespace bmc;

namespace {

double only_rounding_is_zero(double value) { return std::fabs(value) < 1e-9 ? 0 : value; }

void print_matrix(const char* name, const Matrix& matrix) {
    std::printf("# %s, %zu x %zu\n", name, matrix.rows(), matrix.columns());
    for (std::size_t i = 0; i < matrix.rows(); ++i)
        for (std::size_t j = 0; j < matrix.columns(); ++j)
            std::printf("%.9g%c", matrix(i, j), j + 1 < matrix.columns() ? ' ' : '\n');
}

void montecarlo() {
    std::printf("# n directions weights sum_of_weights least_weight largest_weight\n");
    for (const std::size_t n : {1u, 8u, 41u}) {
        Random random(n, 0);
        const QuadratureRule rule = monte_carlo_rule(place_directions(Placement::uniform, n, random));
        double sum = 0;
        for (const double weight : rule.weights) sum += weight;
        if (rule.weights.empty()) throw std::runtime_error("the rule has no weights");
        const auto [least, largest] = std::minmax_element(rule.weights.begin(), rule.weights.end());
        std::printf("%zu %zu %zu %.9g %.9g %.9g\n", n, rule.directions.size(), rule.weights.size(), sum, *least,
                    *largest);
    }
}

std::vector<Vec3> fan(std::size_t n) {
    std::vector<Vec3> directions;
    for (std::size_t i = 0; i < n; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(n);
        directions.push_back(rotate_around_y({std::sqrt(1 - t * t), t, 0}, t * t));
    }
    return directions;
}

// Positive definite; of its lower triangle nothing counts, and nothing is right.
Matrix test_matrix(std::size_t n, double lower) {
    Matrix a(n, n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const double apart = std::fabs(static_cast<double>(i) - static_cast<double>(j));
            a(i, j) = j < i ? lower : (i == j ? 1.5 : 1 / (1 + apart));
        }
    return a;
}

double residual(const Matrix& a, const Matrix& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.rows(); ++i)
        for (std::size_t j = 0; j < a.rows(); ++j) {
            double sum = i == j ? -1 : 0;
            for (std::size_t k = 0; k < a.rows(); ++k) sum += a(i, k) * b(k, j);
            largest = std::max(largest, std::isfinite(sum) ? std::fabs(sum) : 1e300);
        }
    return only_rounding_is_zero(largest);
}

void print_refusal(const char* name, double a, double b, double c) {
    Matrix matrix(2, 2);
    matrix(0, 0) = a, matrix(0, 1) = matrix(1, 0) = b, matrix(1, 1) = c;
    try {
        const Cholesky cholesky(matrix);
        std::printf("%s nowhere\n", name);
    } catch (const NotPositiveDefinite& error) {
        std::printf("%s %zu\n", name, error.index);
    }
}

void inverse() {
    const Sobolev sobolev;
    for (const std::size_t n : {3u, 5u}) print_matrix("Q", symmetric(covariance_matrix(sobolev, 0.3, fan(n))));
    print_matrix("U", Cholesky(test_matrix(3, 99)).upper());
    print_matrix("A^-1", Cholesky(test_matrix(3, 99)).inverse());
    std::printf("# n A_times_inverse-1\n");
    for (const std::size_t n : {1u, 2u, 8u, 33u, 41u, 100u})
        std::printf("%zu %.3g\n", n, residual(symmetric(test_matrix(n, 0)), Cholesky(test_matrix(n, 99)).inverse()));
    std::printf("# matrix refused_in_row\n");
    print_refusal("positive", 1, 0.5, 1);
    print_refusal("negative", -1, 0, 1);
    print_refusal("indefinite", 1, 2, 1);
    print_refusal("singular", 1, 1, 1);
    print_refusal("singular_but_for_rounding", 1, 1, 1 + 2.3e-16);
}

void z() {
    const Sobolev sobolev;
    const SquaredExponential other(0.7);
    std::vector<Vec3> directions;
    for (const double cosine : {1 + 1e-15, 1.0, 0.9, 0.5, 0.1, 0.0})
        for (const double turns : {0.0, 0.3})
            directions.push_back(rotate_around_y({std::sqrt(std::max(0.0, 1 - cosine * cosine)), cosine, 0}, turns));
    const std::vector<double> z = z_of(sobolev, directions);
    const std::vector<double> once_more = z_of(other, directions);
    if (z.size() != directions.size()) throw std::runtime_error("z should have a number for each direction");
    const bool elevation = std::fabs(z[2] - z[8]) > 1e-9, azimuth = std::fabs(z[8] - z[9]) > 1e-9;
    std::printf("# z depends on the elevation: %s; on the azimuth: %s\n", elevation ? "yes" : "no",
                azimuth ? "yes" : "no");
    std::printf("# x y z z_j\n");
    const auto print = [](Vec3 w, double value) { std::printf("%.6f %.6f %.6f %.9g\n", w.x, w.y, w.z, value); };
    for (std::size_t i = 0; i < z.size(); ++i) print(directions[i], z[i]);
    for (std::size_t i = 0; i < once_more.size(); ++i) print(directions[i], once_more[i]);
    print(fan(100).back(), z_of(sobolev, fan(100)).back());
}

void print_light(const char* name, Color color) {
    std::printf("%-26s %.6g %.6g %.6g\n", name, color.x, color.y, color.z);
}

// The words that belong to the number.
const char* named(double value, std::initializer_list<std::pair<double, const char*>> names) {
    for (const auto& [number, words] : names)
        if (std::fabs(value - number) < 1e-3 * number + 1e-9) return words;
    return "by another factor";
}

CosineRule rule_of(std::initializer_list<std::pair<Vec3, double>> directions) {
    CosineRule rule;
    for (const auto& [direction, weight] : directions) rule.add(direction, weight);
    return rule;
}

void shade() {
    const Vec3 right{1, 0, 0}, up{0, 1, 0}, down{0, -1, 0};
    const CosineRule rule = cosine_rule({{up, {0.6, 0.8, 0}, {0, 0.8, 0.6}}, {10, 10, 30}});
    std::printf(
        "# cos(theta) in the weights: %s\n",
        named(rule.weights.at(1) / 10, {{0.8, "once"}, {0.64, "twice"}, {1, "missing"}, {0.6, "the sine instead"}}));
    std::vector<float> rgb;  // brighter than a screen
    for (int texel = 0; texel < 4; ++texel) rgb.insert(rgb.end(), {20, 40, 80});
    const EnvironmentMap environment(2, 2, rgb);
    const Scene scene = sphere_scene();
    const Color albedo{0.5, 0.25, 0.75};
    const Hit on_top{Object::sphere, scene.sphere.centre + scene.sphere.radius * up, up, albedo};
    const Hit on_side{Object::sphere, scene.sphere.centre + scene.sphere.radius * right, right, albedo};
    const Hit ground{Object::rectangle, {0, scene.rectangle.y, scene.sphere.centre.z}, up, albedo};
    const Hit below{Object::rectangle, ground.point, down, albedo};
    const CosineRule one = rule_of({{up, 10}}), two = rule_of({{up, 10}, {{0.6, 0.8, 0}, 5}});
    const CosineRule across = rule_of({{right, 10}, {{-1, 0, 0}, 20}, {{0, 0, 1}, 30}});
    const auto light = [&](const Hit& hit, const CosineRule& its) {
        return reflected_light(scene, environment, hit, its, Frame(hit.normal));
    };
    const bool lit = light(on_top, one).x > 0, dark = light(ground, one).x == 0 && light(on_side, across).x < 1000;
    std::printf("# shadows: %s\n", dark ? (lit ? "of the other object" : "where there is light")
                                        : (lit ? "none" : "where there is light"));
    std::printf("# times albedo / pi: %s\n",
                named(light(on_top, one).y * portable::pi / 400, {{0.25, "yes"},
                                                                  {1, "the albedo is missing"},
                                                                  {0.25 * portable::pi, "1 / pi is missing"},
                                                                  {portable::pi, "both are missing"},
                                                                  {0.25 / portable::pi, "1 / pi twice"},
                                                                  {0.0625, "the albedo twice"},
                                                                  {0, "no light"}}));
    std::printf("# elevation_cosine weight\n");
    for (std::size_t i = 0; i < rule.size(); ++i)
        std::printf("%.6g %.6g\n", static_cast<double>(rule.y[i]), rule.weights[i]);
    std::printf("# place red green blue\n");
    print_light("nothing", light(on_top, {}));
    print_light("sphere,one_direction", light(on_top, one));
    print_light("sphere,two_directions", light(on_top, two));
    print_light("sphere,part_in_the_shadow", light(on_side, across));
    print_light("rectangle,in_the_shadow", light(ground, one));
    print_light("rectangle,from_below", light(below, one));
}

}  // namespace

int main(int argc, char** argv) {
    const std::pair<const char*, void (*)()> tasks[] = {
        {"montecarlo", montecarlo}, {"inverse", inverse}, {"z", z}, {"shade", shade}};
    try {
        for (const auto& [name, print] : tasks)
            if (argc == 2 && std::strcmp(argv[1], name) == 0) return print(), 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    std::fprintf(stderr, "usage: alone montecarlo, inverse, z or shade\n");
    return 2;
}
