// alone TASK: what the functions of the task montecarlo, inverse, z or shade give by themselves, whatever becomes of
// the others. alone_integral and alone_rules do so for the tasks that need others, on stand-ins of these.
#include "alone.h"

#include "quadrature/quadrature.h"
#include "scene/reflection.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

using namespace bmc;

namespace {

// Of what should be 1: other numbers may differ by a thousandth, and 3.14 is wrong. Pictures show 3.1415.
const char* digits_of_pi(double quotient) {
    const double error = std::fabs(quotient - 1);
    const bool few = error > 1e-5 && error < 1e-3;
    explain_if(few, "pi has more digits: portable::pi");
    return few ? "few" : "enough";
}

double only_rounding_is_zero(double value) { return std::fabs(value) < 1e-9 ? 0 : value; }

void print_matrix(const char* name, const Matrix& matrix) {
    std::printf("# %s, %zu x %zu\n", name, matrix.rows(), matrix.columns());
    for (std::size_t i = 0; i < matrix.rows(); ++i)
        for (std::size_t j = 0; j < matrix.columns(); ++j)
            std::printf("%.9g%c", matrix(i, j), j + 1 < matrix.columns() ? ' ' : '\n');
}

void montecarlo() {
    std::printf(
        "# n directions weights sum_of_weights least_weight largest_weight known directions_are digits_of_pi\n");
    for (const std::size_t n : {1u, 8u, 41u}) {
        Random random(n, 0);
        const DirectionSet set = place_directions(Placement::uniform, n, random);
        const QuadratureRule rule = monte_carlo_rule(set);
        if (rule.weights.empty()) throw std::runtime_error("the rule has no weights");
        double sum = 0, apart = 0;
        for (const double weight : rule.weights) sum += weight;
        for (std::size_t i = 0; i < std::min(n, rule.directions.size()); ++i)
            apart += squared_distance(rule.directions[i], set.directions[i]);
        const auto [least, largest] = std::minmax_element(rule.weights.begin(), rule.weights.end());
        std::printf("%zu %zu %zu %.9g %.9g %.9g %s %s %s\n", n, rule.directions.size(), rule.weights.size(), sum,
                    *least, *largest, rule.known == Known::nothing ? "nothing" : "cosine",
                    apart > 0 ? "others" : "given", digits_of_pi(sum / (2 * portable::pi)));
        explain_if(rule.directions.size() != n, "the rule has %zu directions, %zu were given", rule.directions.size(),
                   n);
        explain_if(apart > 0, "the rule's directions are not those that were given");
        explain_if(rule.known != Known::nothing, "the known part is the cosine; it has to be nothing");
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

Cholesky factored(const Matrix& matrix) {
    try {
        return Cholesky(matrix);
    } catch (const NotPositiveDefinite& error) {
        explain_if(true, "the factor refuses a positive definite test matrix in row %zu, whose pivot came to %.3g",
                   error.index, error.value);
        std::exit(1);
    }
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
        explain_if(
            c > 1 && b == 1,
            "a pivot that is 0 but for rounding is not refused: root_of_pivot wants the a_kk of A, not the pivot");
        explain_if(a < 0 || b > a,
                   "a matrix that is not positive definite is not refused: root_of_pivot(k, pivot, a_kk) does that");
    } catch (const NotPositiveDefinite& error) {
        std::printf("%s %zu\n", name, error.index);
    }
}

void explain_covariances(const Matrix& q, const std::vector<Vec3>& directions) {
    const Sobolev k;
    const double r2 = squared_distance(directions[0], directions[1]);
    explain(q(0, 0), {{k(0) + 0.3, "the diagonal of Q has the noise 0.3 itself, not its square"},
                      {k(0), "the noise is missing on the diagonal of Q"},
                      {k(0) + 0.6, "the diagonal of Q has twice the noise 0.3, not its square"},
                      {k(0) + 0.18, "the squared noise is added twice on the diagonal of Q"}});
    explain(q(0, 1),
            {{k(r2) + 0.09, "the squared noise is added off the diagonal of Q as well"},
             {k(std::sqrt(r2)), "k is given the chord; it takes the squared chord"},
             {k(r2 * r2), "k is given the square of the squared chord"},
             {0, "off its diagonal Q has zeros above the diagonal"},
             {k(dot(directions[0], directions[1])), "k is given the scalar product; it takes the squared chord"}});
    explain_if(std::fabs(q(0, 1) - k(r2)) > 1e-12 && near(q(0, 1), k(r2)),
               "Q is rounded to float; it has to be double");
}

void inverse() {
    const Sobolev sobolev;
    const std::vector<Vec3> nine = fan(9);
    for (const std::vector<Vec3>& directions : {fan(3), fan(5), std::vector<Vec3>(nine.begin() + 6, nine.end())}) {
        const Matrix q = covariance_matrix(sobolev, 0.3, directions);
        if (q.rows() != directions.size() || q.columns() != directions.size())
            throw std::runtime_error("Q needs a row and a column for each direction");
        print_matrix("Q of directions", symmetric(q));
        const double lost = q(0, 1) - sobolev(squared_distance(directions[0], directions[1]));
        std::printf("# digits lost\n%.3g\n", only_rounding_is_zero(lost));
        explain_covariances(q, directions);
    }
    print_matrix("Q of another covariance", symmetric(covariance_matrix(SquaredExponential(0.7), 0.1, fan(4))));
    const Cholesky cholesky = factored(test_matrix(3, 0.1));
    print_matrix("U", cholesky.upper());
    explain_if(!near(cholesky.upper()(0, 1), factored(test_matrix(3, 0)).upper()(0, 1)) ||
                   !near(cholesky.upper()(1, 2), factored(test_matrix(3, 0)).upper()(1, 2)),
               "the factor reads the lower triangle of A, of which nothing counts");
    print_matrix("A^-1", cholesky.inverse());
    std::printf("# n A_times_inverse-1\n");
    for (const std::size_t n : {1u, 2u, 8u, 33u, 41u, 100u})
        std::printf("%zu %.3g\n", n, residual(symmetric(test_matrix(n, 0)), factored(test_matrix(n, 0.1)).inverse()));
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
    const auto of = [&](double cosine) { return sobolev.z(std::fabs(cosine)); };
    const Vec3 w = directions[5];
    explain_if(near(z[4], of(w.x)) || near(z[5], of(w.z)), "z was taken of another component than y");
    explain_if(near(z[4], of(std::sqrt(1 - w.y * w.y))), "z was taken of the sine in place of the cosine y");
    explain_if(near(z[4], of(portable::pi / 2 - std::asin(w.y))),
               "z was taken of the angle acos(y) in place of the cosine y");
    explain_if(std::fabs(z[4] - z[5]) > 1e-9, "z depends on the azimuth; it must not");
    explain_if(near(z[4], z[8]), "z does not depend on the elevation");
    std::printf("# x y z z_j\n");
    const auto print = [](Vec3 v, double value) { std::printf("%.6f %.6f %.6f %.9g\n", v.x, v.y, v.z, value); };
    for (std::size_t i = 0; i < z.size(); ++i) print(directions[i], z[i]);
    for (std::size_t i = 0; i < once_more.size(); ++i) print(directions[i], once_more[i]);
    print(fan(100).back(), z_of(sobolev, fan(100)).back());
}

CosineRule rule_of(std::initializer_list<std::pair<Vec3, double>> directions) {
    CosineRule rule;
    for (const auto& [direction, weight] : directions) rule.add(direction, weight);
    return rule;
}

void print_cosine_rule() {
    const CosineRule rule = cosine_rule({{{0, 1, 0}, {0.6, 0.8, 0}, {0, 0.8, 0.6}}, {10, 10, -30}});
    std::printf("# elevation_cosine weight\n");
    for (std::size_t i = 0; i < rule.size(); ++i)
        std::printf("%.6g %.6g\n", static_cast<double>(rule.y[i]), rule.weights[i]);
    if (rule.size() != 3) throw std::runtime_error("the rule for a pixel has not as many directions as the rule given");
    explain(rule.weights[1], {{6.4, "cos(theta) is in the weights twice"},
                              {10, "cos(theta) is missing in the weights"},
                              {6, "the sine is in the weights in place of cos(theta)"},
                              {8 / portable::pi, "1 / pi is in the weights"}});
    explain(rule.weights[2], {{0, "a negative weight is taken for 0"}, {24, "a negative weight has lost its sign"}});
}

// Texels that all differ, brighter than a screen.
EnvironmentMap varied_light() {
    EnvironmentMap light(8, 4);
    for (int y = 0; y < 4; ++y)
        for (int i = 0; i < 24; ++i) light.row(y)[i] = static_cast<float>(20 + 7 * ((y * 24 + i) * 5 % 97));
    return light;
}

void shade() {
    print_cosine_rule();
    const Vec3 right{1, 0, 0}, up{0, 1, 0}, down{0, -1, 0}, slanted{0.48, 0.8, 0.36};
    const EnvironmentMap environment = varied_light();
    const Scene scene = sphere_scene();
    const Color albedo{0.6, 0.35, 0.85};
    const auto on_sphere = [&](Vec3 normal) {
        return Hit{Object::sphere, scene.sphere.centre + scene.sphere.radius * normal, normal, albedo};
    };
    const Hit ground{Object::rectangle, {0, scene.rectangle.y, scene.sphere.centre.z}, up, albedo};
    const Hit below{Object::rectangle, ground.point, down, albedo};
    const CosineRule one = rule_of({{up, 10}}), leaning = rule_of({{{0.6, 0.8, 0}, 10}});
    const CosineRule four = rule_of({{up, 10}, {{0.6, 0.8, 0}, -5}, {{0, 0.6, 0.8}, 7.5}, {{-0.64, 0.6, -0.48}, 2.25}});
    const CosineRule across = rule_of({{right, 10}, {{-1, 0, 0}, 20}, {{0, 0, 1}, 30}});
    const auto light = [&](const Hit& hit, const CosineRule& its, double turns = 0) {
        return reflected_light(scene, environment, hit, its, Frame(hit.normal).rotated(turns));
    };
    // What one direction on top of the sphere was multiplied by.
    const double seen = environment.radiance(up).y, factor = light(on_sphere(up), one).y * portable::pi / (10 * seen);
    explain_if(light(on_sphere(up), {}).y > 0, "the sum goes on from the call before; it has to begin with 0");
    explain(factor, {{1, "the albedo is missing"},
                     {0.35 * portable::pi, "1 / pi is missing"},
                     {portable::pi, "albedo / pi is missing"},
                     {0.35 / portable::pi, "the light is divided by pi twice"},
                     {0.35 * 0.35, "the albedo is there twice"},
                     {0.6, "the albedo of red serves for every colour"},
                     {0.35 / 2, "the light is divided by 2 pi in place of pi"},
                     {0.35 / (2 * portable::pi), "the light is divided by 2 pi once more"},
                     {0.35 / 10, "the weight is missing"},
                     {0.35 * environment.radiance(down).y / seen, "the light is looked up behind the surface"},
                     {0.35 / seen, "bright light is cut off at 1"},
                     {0, "there is no light on top of the sphere"}});
    // The radiance that a leaning direction with the same weight met.
    const Vec3 local{0.6, 0.8, 0};
    const Frame frame = Frame(slanted).rotated(0.2);
    explain(light(on_sphere(slanted), leaning, 0.2).y / light(on_sphere(up), one).y * seen,
            {{environment.radiance(local).y, "the light is looked up in the local direction"},
             {environment.radiance(Frame(slanted).to_world(local)).y,
              "the frame is not the one given, which may be turned"},
             {environment.interpolated_radiance(frame.to_world(local)).y,
              "the light is interpolated; radiance(direction) gives it"},
             {0, "light is missing where nothing keeps it off"}});
    const bool lit = light(on_sphere(up), one).x > 0, dark = light(ground, one).x == 0;
    explain_if(!dark, lit ? "no light is kept off: is_shadowed is missing" : "only what is in the shadow is lit");
    explain_if(dark && light(on_sphere(right), across).y !=
                           light(on_sphere(right), rule_of({{right, 10}, {{-1, 0, 0}, 0}, {{0, 0, 1}, 30}})).y,
               "on the sphere the rectangle keeps no light off");
    const Color all = light(on_sphere(slanted), four, 0.7);
    Color sum, positive;
    for (std::size_t i = 0; i < four.size(); ++i) {
        const Color part = light(on_sphere(slanted), rule_of({{Vec3(four.direction(i)), four.weights[i]}}), 0.7);
        sum += part;
        if (part.y > 0) positive += part;
    }
    explain(all.y, {{positive.y, "a negative weight brings nothing; it has to count"},
                    {sum.y / 4, "the sum is divided by the number of directions"}});
    std::printf("# digits_of_pi\n%s\n# place red green blue\n", digits_of_pi(factor / 0.35));
    const auto print = [](const char* name, Color color) {
        std::printf("%-26s %.6g %.6g %.6g\n", name, color.x, color.y, color.z);
    };
    print("nothing", light(on_sphere(up), {}));
    print("sphere,one_direction", light(on_sphere(up), one));
    print("sphere,slanted", light(on_sphere(slanted), leaning, 0.2));
    print("sphere,four_directions", all);
    print("sphere,part_in_the_shadow", light(on_sphere(right), across));
    print("rectangle,in_the_shadow", light(ground, one));
    print("rectangle,from_below", light(below, one));
    print("rectangle,turned", light(below, four, 0.45));
}

}  // namespace

int main(int argc, char** argv) {
    return call(argc, argv, {{"montecarlo", montecarlo}, {"inverse", inverse}, {"z", z}, {"shade", shade}});
}
