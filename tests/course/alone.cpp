// alone TASK: what the functions of the task montecarlo, inverse, z or shade give by themselves, whatever becomes of
// the others. alone_integral and alone_rules do so for the tasks that need others, on stand-ins of these.
#include "alone.h"

#include "numerics/formatted.h"
#include "quadrature/quadrature.h"
#include "scene/reflection.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <tuple>

using namespace bmc;
using portable::pi;

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
    std::printf("# %s, %zux%zu\n", name, matrix.rows(), matrix.columns());
    for (std::size_t i = 0; i < matrix.rows(); ++i)
        for (std::size_t j = 0; j < matrix.columns(); ++j)
            std::printf("%.9g%c", matrix(i, j), j + 1 < matrix.columns() ? ' ' : '\n');
}

void montecarlo() {
    function = "monte_carlo_rule";
    Trial weights;
    for (const std::size_t n : {8u, 1u, 41u}) {
        Random random(n, 0);
        const DirectionSet set = place_directions(Placement::uniform, n, random);
        const QuadratureRule rule = monte_carlo_rule(set);
        if (rule.weights.empty()) throw std::runtime_error("the rule has no weights: is size() read after std::move?");
        explain_if(rule.weights.size() != n, "the rule has %zu weights for %zu directions", rule.weights.size(), n);
        explain_if(rule.directions.size() != n, "the rule has %zu directions, %zu were given", rule.directions.size(),
                   n);
        bool same = true;
        double cosines = 0;
        for (const Vec3& direction : set.directions) cosines += direction.y;
        for (std::size_t i = 0; i < std::min({n, rule.directions.size(), rule.weights.size()}); ++i) {
            same = same && squared_distance(rule.directions[i], set.directions[i]) == 0;
            Quantities quantities = count(static_cast<double>(n));
            quantities.push_back({"(i+1)", static_cast<double>(i + 1)});
            quantities.push_back({"the sum of the cosines", cosines});
            weights.add(rule.weights[i],
                        mistakes(2 * pi / static_cast<double>(n),
                                 {{{1 / (2 * pi)}, " is a density, 1 / (2 pi)"},
                                  {{n > 1 ? 0 : 2 * pi}, " is 0 but for n = 1: whole numbers divided?"}},
                                 angle(set.directions[i].y, quantities), i, n));
        }
        explain_if(!same, "the rule's directions are not those that were given");
        explain_if(rule.known != Known::nothing, "the known part is the cosine; it has to be nothing");
        const char* digits = digits_of_pi(rule.weights[0] * static_cast<double>(n) / (2 * pi));
        std::printf("# n directions weights known directions_are digits_of_pi\n%zu %zu %zu %s %s %s\n# weight\n", n,
                    rule.directions.size(), rule.weights.size(), rule.known == Known::nothing ? "nothing" : "cosine",
                    same ? "given" : "others", digits);
        for (const double weight : rule.weights) std::printf("%.9g\n", weight);
    }
    weights.passes("a weight");
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
            a(i, j) = j < i ? lower : i == j ? 1.5 + static_cast<double>(i) / 10 : 1 / (1 + apart);
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

// What a b - 1 has in row i and column j, but for rounding.
double error(const Matrix& a, const Matrix& b, std::size_t i, std::size_t j) {
    double sum = i == j ? -1 : 0;
    for (std::size_t k = 0; k < a.rows(); ++k) sum += a(i, k) * b(k, j);
    return std::fabs(sum) < 1e-9 ? 0 : std::isfinite(sum) ? sum : 1e300;
}

double residual(const Matrix& a, const Matrix& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.rows(); ++i)
        for (std::size_t j = 0; j < a.rows(); ++j) largest = std::max(largest, std::fabs(error(a, b, i, j)));
    return largest;
}

void print_refusals(bool factor_is_right) {
    std::printf("# matrix refused_in_row\n");
    for (const auto& [name, a, b, c] : {std::tuple("positive", 1.0, 0.5, 1.0),
                                        {"negative", -1, 0, 1},
                                        {"indefinite", 1, 2, 1},
                                        {"singular", 1, 1, 1},
                                        {"singular_but_for_rounding", 1, 1, 1 + 2.3e-16}}) {
        Matrix matrix(2, 2);
        matrix(0, 0) = a, matrix(0, 1) = matrix(1, 0) = b, matrix(1, 1) = c;
        try {
            const Cholesky cholesky(matrix);
            std::printf("%s nowhere\n", name);
            explain_if(
                factor_is_right && c > 1,
                "a pivot that is 0 but for rounding is not refused: root_of_pivot wants the a_kk of A, not the pivot");
            explain_if(
                factor_is_right && (a < 0 || b > a),
                "a matrix that is not positive definite is not refused: root_of_pivot(k, pivot, a_kk) does that");
        } catch (const NotPositiveDefinite& error) {
            std::printf("%s %zu\n", name, error.index);
        }
    }
}

// Whether the factor is right. Each element is tried by those before it, the student's own.
bool explain_factor(const Matrix& a, const Matrix& u) {
    Trial elements, sums;
    std::string about;
    for (std::size_t k = 0; k < a.rows(); ++k)
        for (std::size_t j = k; j < a.rows(); ++j) {
            std::vector<double> terms;
            double rest = a(k, j), squares = a(k, j);
            for (std::size_t i = k; i-- > 0; squares -= u(i, k) * u(i, k))
                terms.push_back(u(i, k) * u(i, j)), rest -= terms.back();
            const bool diagonal = j == k;
            const double sum = a(k, j) - rest;
            const auto of = [&](double its) { return diagonal ? std::sqrt(its) : its / u(k, k); };
            if (about.empty() && !near(u(k, j), of(rest)))
                about = formatted("the factor is right as far as here: k = %zu, j = %zu", k, j);
            elements.add(
                u(k, j),
                mistakes(of(rest),
                         {{{of(a(k, j))}, " has nothing subtracted from a_kj"},
                          {{of(a(k, j) + sum)}, " has the sum over i < k added; it is to be subtracted"},
                          {{rest}, " lacks a root or the division by u_kk"},
                          {{diagonal ? of(rest) : rest}, " lacks the division by u_kk"},
                          {{diagonal ? of(rest) : rest / a(k, k), diagonal ? of(rest) : rest / std::sqrt(a(j, j))},
                           " is divided by an element of A's diagonal or its root; it should be u_kk"},
                          {{of(squares)}, " has u_ik squared in its sum; the second factor is u_ij"},
                          {{a(k, j)}, " is a_kj still"}},
                         {{"u_kk", u(k, k)}}));
            if (k > 0) sums.add(a(k, j) - u(k, j) * u(k, diagonal ? j : k), mistakes(terms, {}));
        }
    if (about.empty()) return true;
    elements.passes(about + ": u_kj");
    sums.passes(about + ": the sum over i < k");
    explain_if(true, "%s", about.c_str());
    return false;
}

// Of a factor that is right.
void explain_inverse(const Matrix& a, const Cholesky& cholesky, const Matrix& x) {
    const std::size_t n = a.rows();
    if (x.rows() != n || x.columns() != n) throw std::runtime_error("A^-1 needs a row and a column for each of A");
    explain_if(residual(cholesky.upper(), x) == 0, "this is the inverse of U, not of A");
    Trial elements;
    std::string solved;
    for (std::size_t j = 0; j < n; ++j) {
        std::vector<double> e(n);
        e[j] = 1;
        const std::vector<double> right = cholesky.solve(e), half = cholesky.solve_lower(e);
        std::string b;
        bool wrong = false;
        for (std::size_t i = 0; i < n; ++i) {
            wrong = wrong || error(a, x, i, j) != 0,
            b += formatted(" %.3g", only_rounding_is_zero(error(a, x, i, j) + e[i]));
            elements.add(x(i, j),
                         mistakes(right[i], {{{half[i]}, ": its columns are those of solve_lower; take solve"},
                                             {{1 / a(i, j), 1 / cholesky.upper()(i, j)}, " is 1 over an element"}}));
        }
        if (wrong && solved.empty()) solved = formatted("column %zu of A^-1 is what solve returns for%s", j, b.c_str());
    }
    elements.passes("an element of A^-1");
    explain_if(!solved.empty(), "%s", solved.c_str());
}

void inverse() {
    function = "covariance_matrix";
    const Sobolev sobolev;
    const SquaredExponential other(0.7);
    const std::vector<Vec3> nine = fan(9);
    Trial added, others, arguments;
    bool rounded = false;
    const auto print_q = [&](const char* name, const Covariance& k, double noise, const std::vector<Vec3>& directions) {
        const std::size_t n = directions.size();
        const Matrix q = covariance_matrix(k, noise, directions);
        if (q.rows() != n || q.columns() != n)
            throw std::runtime_error("Q needs a row and a column for each direction");
        print_matrix(name, symmetric(q));
        constexpr const char* own = "Q is made of the kernel 8/3 - r whatever covariance is given";
        for (std::size_t i = 0; i < n; ++i) {
            const double square = noise * noise, k_0 = k(0);
            added.add(
                q(i, i) - k_0,
                mistakes(square,
                         {{{0}, "the noise is missing on the diagonal of Q"},
                          {{noise}, " is the noise itself, not its square"},
                          {{8.0 / 3 + square - k_0}, own},
                          {{square - k_0, noise - k_0}, "the diagonal of Q lacks k: k(0) is not 0"},
                          {{k(square) - k_0}, "the squared noise goes into k; it is added to k on the diagonal of Q"}},
                         {{"noise", noise}, {"k(0)", k_0}}, i, n));
            for (std::size_t j = i + 1; j < n; ++j) {
                const double r2 = squared_distance(directions[i], directions[j]), r = std::sqrt(r2),
                             scalar = dot(directions[i], directions[j]);
                const Quantities quantities{{"noise", noise},
                                            {"r", r},
                                            {"w_i.w_j", scalar},
                                            {"acos(w_i.w_j)", std::acos(scalar)},
                                            {"k(0)", k_0}};
                others.add(q(i, j), mistakes(k(r2),
                                             {{{k_0}, " has k(0): the distance of a direction to itself"},
                                              {{8.0 / 3 - r}, own},
                                              {{k(std::fabs(scalar)), k(std::max(0.0, scalar))},
                                               "k is given the scalar product; it takes the squared chord"}},
                                             quantities, j, n));
                arguments.add(-argument([&](double minus) { return k(-minus); }, q(i, j), -16, 0),
                              mistakes(r2, {{{r}, "k is given the chord; it takes the squared chord"}}, quantities));
                rounded = rounded || (std::fabs(q(i, j) - k(r2)) > 1e-12 && near(q(i, j), k(r2)));
            }
        }
        std::printf("# digits lost\n%.3g\n",
                    only_rounding_is_zero(q(0, 1) - k(squared_distance(directions[0], directions[1]))));
    };
    for (const std::vector<Vec3>& directions : {fan(3), fan(5), std::vector<Vec3>(nine.begin() + 6, nine.end())})
        print_q("Q of directions", sobolev, 0.3, directions);
    print_q("Q of another covariance", other, 0.1, fan(4));
    others.passes("off its diagonal Q");
    arguments.passes("what k is given, which should be the squared chord,");
    added.passes("what is added to k(0) on the diagonal of Q");
    explain_if(rounded, "Q is rounded to float; it has to be double");
    function = "factor";
    const Matrix a = symmetric(test_matrix(4, 0));
    const Cholesky cholesky = factored(test_matrix(4, 0.1));
    const Matrix u = cholesky.upper(), x = cholesky.inverse();
    print_matrix("U", u);
    const Matrix same = factored(test_matrix(4, 0)).upper();
    const bool reads = !near(u(0, 1), same(0, 1)) || !near(u(1, 2), same(1, 2));
    explain_if(reads, "the factor reads the lower triangle of A, of which nothing counts");
    const bool right = explain_factor(a, u);
    function = "inverse";
    print_matrix("A^-1", x);
    if (right) explain_inverse(a, cholesky, x);
    std::printf("# n A_times_inverse-1\n");
    for (const std::size_t n : {1u, 2u, 8u, 33u, 41u, 100u})
        std::printf("%zu %.3g\n", n, residual(symmetric(test_matrix(n, 0)), factored(test_matrix(n, 0.1)).inverse()));
    function = "factor";
    print_refusals(right);
}

void z() {
    function = "z_of";
    const Sobolev sobolev;
    const SquaredExponential other(0.7);
    std::vector<Vec3> directions;
    for (const double cosine : {1.0, 0.9, 0.5, 0.1, 0.0})
        for (const double turns : {0.0, 0.3})
            directions.push_back(rotate_around_y({std::sqrt(std::max(0.0, 1 - cosine * cosine)), cosine, 0}, turns));
    std::printf("# x y z z_j\n");
    Trial all, cosines;
    bool alone = true;
    const auto take = [&](const Covariance& k, const std::vector<Vec3>& its) {
        const std::vector<double> z = z_of(k, its);
        if (z.size() != its.size()) throw std::runtime_error("z should have a number for each direction");
        for (std::size_t i = 0; i < z.size(); ++i) {
            const double y = std::min(1.0, its[i].y), n = static_cast<double>(z.size());
            const Quantities quantities = angle(
                y, {{"n", n}, {"zz", k.integral_of_z()}, {"|x|", std::fabs(its[i].x)}, {"|z|", std::fabs(its[i].z)}});
            double sum = 0;
            for (const Vec3& w : its) sum += k(squared_distance(its[i], w));
            all.add(
                z[i],
                mistakes(
                    k.z(y),
                    {{{Sobolev().z(y)}, " is always the default covariance's; take the one given"},
                     {{k.z(1), k.z(0)}, " does not depend on the elevation"},
                     {{k.z(std::min(1.0, std::acos(y)))}, " is of the angle; covariance.z takes its cosine, y"},
                     {{sum, sum * 2 * pi / n}, " is a sum of k over the directions given; it is an integral over H"},
                     {{k(y), k(1 - y), k(2 - 2 * y)}, "this is k of y, not z: covariance.z gives the integral"}},
                    quantities, i, z.size()));
            cosines.add(argument([&](double cosine) { return k.z(cosine); }, z[i], 0, 1),
                        mistakes(y, {{{std::cos(y)}, " is cos(y)"}}, quantities));
            alone = alone && near(z_of(k, {its[i]}).at(0), k.z(y));
            std::printf("%.6f %.6f %.6f %.9g\n", its[i].x, its[i].y, its[i].z, z[i]);
        }
    };
    take(sobolev, directions);
    take(other, directions);
    take(sobolev, fan(100));
    const bool good = all.passes("z");
    cosines.passes("z was taken of another cosine than y: what it was taken of");
    explain_if(!good && alone,
               "z of a direction is right where that is the only one; which others there are must not count");
    std::size_t apart = 0, pairs = 0;
    for (std::size_t i = 2; i < directions.size(); i += 2, ++pairs)
        if (std::fabs(all.given[i] - all.given[i + 1]) > 1e-9) ++apart;
    explain_if(!good && apart == pairs, "z depends on the azimuth; it must not");
    take(sobolev, {{0, 1 + 1e-15, 0}});  // which rounding may give
}

CosineRule rule_of(std::initializer_list<std::pair<Vec3, double>> directions) {
    CosineRule rule;
    for (const auto& [direction, weight] : directions) rule.add(direction, weight);
    return rule;
}

void print_cosine_rule() {
    function = "cosine_rule";
    const std::vector<Vec3> directions{{0.6, 0.8, 0}, {0, 1, 0}, {0, 0.8, 0.6}, {0, 0.28, 0.96}};
    const std::vector<double> weights{10, 10, -30, 5};
    const CosineRule rule = cosine_rule({directions, weights});
    std::printf("# elevation_cosine weight\n");
    for (std::size_t i = 0; i < rule.size(); ++i)
        std::printf("%.6g %.6g\n", static_cast<double>(rule.y[i]), rule.weights[i]);
    if (rule.size() != 4)
        throw std::runtime_error(
            formatted("the rule for a pixel has %zu directions, the rule given has 4", rule.size()));
    Trial trial;
    for (std::size_t i = 0; i < 4; ++i) {
        explain_if(squared_distance(Vec3(rule.direction(i)), directions[i]) > 1e-6,
                   "the directions of the rule for a pixel are not those given: they stay, and only weights change");
        const double weight = weights[i], y = directions[i].y;
        trial.add(rule.weights[i],
                  mistakes(weight * y,
                           {{{y}, " is cos(theta): the weights given are missing"},
                            {{weights[0] * y, weights[3] * y}, " has the first or the last weight, whichever it is of"},
                            {{0.8 * weight, 0.28 * weight},
                             " has the cosine of the first or the last direction, whichever it is of"},
                            {{weight + y}, " has cos(theta) added to it"},
                            {{weight * std::cos(y)}, " has cos(y) in it; y is cos(theta)"}},
                           angle(y, {{"the weight given", weight}}), i, 4));
    }
    trial.passes("a weight of the rule for a pixel");
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
    function = "reflected_light";
    const Vec3 right{1, 0, 0}, up{0, 1, 0}, down{0, -1, 0}, slanted{0.48, 0.8, 0.36};
    const EnvironmentMap environment = varied_light();
    const Scene scene = sphere_scene();
    const Color albedo{0.6, 0.35, 0.7};
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
    // The green that a pixel on top of the sphere reflects, by weights of the direction up.
    const double nothing = light(on_sphere(up), {}).y, seen = environment.radiance(up).y, unit = albedo.y / pi * seen;
    Trial sums, leanings, shadows;
    for (const std::vector<double>& weights : {std::vector<double>{10}, {5}, {10, 5}, {10, 5, -3}}) {
        CosineRule rule;
        double sum = 0;
        for (const double weight : weights) rule.add(up, weight), sum += weight;
        const Color given = light(on_sphere(up), rule);
        for (double Color::*const colour : {&Color::x, &Color::y, &Color::z}) {
            const double its = environment.radiance(up).*colour, behind = environment.radiance(down).*colour;
            std::vector<double> terms;
            for (const double weight : weights) terms.push_back(albedo.*colour / pi * its * weight);
            const double all = sum * its / pi;
            sums.add(
                given.*colour,
                mistakes(terms,
                         {{{0},
                           "there is no light on top of the sphere: is it lit where is_shadowed says so, or asked "
                           "another way?"},
                          {{albedo.x * all, albedo.y * all, albedo.z * all, (albedo.x + albedo.y + albedo.z) / 3 * all},
                           "the albedo of one colour, or the mean, serves for all"},
                          {{dot(albedo, environment.radiance(up)) / pi * sum},
                           " is a sum over the colours: albedo * radiance has three of its own, dot only one"},
                          {{albedo.*colour / pi * sum * behind}, " is looked up behind the surface"}},
                         {{"n", static_cast<double>(weights.size())},
                          {"the sum of the weights", sum},
                          {"the albedo", albedo.*colour},
                          {"the radiance", its}}));
        }
    }
    explain_if(nothing > 0,
               "a rule without directions reflects light: what is added to the sum, or stands in its place?");
    explain_if(light(on_sphere(up), {}).y > nothing, "the sum goes on from the call before; it has to begin with 0");
    const auto from = [&](Vec3 direction) { return albedo.y / pi * 10 * environment.radiance(direction).y; };
    // Directions that lean, on a slanted surface whose frame is turned.
    for (const Vec3 local : {Vec3{0.6, 0.8, 0}, {0, 0.6, 0.8}, {-0.28, 0.96, 0}}) {
        const Vec3 world = Frame(slanted).rotated(0.2).to_world(local);
        leanings.add(
            light(on_sphere(slanted), rule_of({{local, 10}}), 0.2).y,
            mistakes(from(world),
                     {{{from(local)}, " is looked up in the local direction"},
                      {{from(Frame(slanted).to_world(local))}, "the frame is not the one given, which may be turned"},
                      {{albedo.y / pi * 10 * environment.interpolated_radiance(world).y},
                       " is interpolated; radiance(direction) gives it"},
                      {{from(slanted)}, " is looked up along the normal"},
                      {{from(-1.0 * world)}, " is looked up behind the surface"},
                      {{0}, " is missing where nothing keeps it off"}},
                     angle(local.y, {{"y of the direction in the world", world.y}})));
    }
    // On the sphere's side, from where the rectangle hides half of the horizon.
    const Vec3 left{-1, 0, 0}, front{0, 0, 1}, back{0, 0, -1};
    for (const std::vector<Vec3>& around :
         {std::vector<Vec3>{right}, {left}, {front}, {back}, {right, left, front}, {left, back, right}}) {
        CosineRule rule;
        double lit = 0, to_break = 0, all = 0, by_opposite = 0;
        bool hid = false;
        for (const Vec3 local : around) {
            const Vec3 world = Frame(right).to_world(local);
            const auto seen_by = [&](Vec3 w) { return is_shadowed(scene, on_sphere(right), w) ? 0 : from(world); };
            rule.add(local, 10);
            hid = hid || seen_by(world) == 0;
            all += from(world), lit += seen_by(world), to_break += hid ? 0 : from(world);
            by_opposite += seen_by(-1.0 * world);
        }
        shadows.add(
            light(on_sphere(right), rule).y,
            mistakes(
                lit,
                {{{all},
                  "on the sphere the rectangle keeps no light off: is_shadowed asked from elsewhere, or another way?"},
                 {{by_opposite}, "is_shadowed is asked about the opposite direction"},
                 {{all - lit}, "only what is in the shadow is lit"},
                 {{to_break}, "the loop ends at the first direction in the shadow: break in place of continue?"},
                 {{hid ? 0 : lit}, "one direction in the shadow makes all dark: return in place of continue?"},
                 {{2 * lit - all}, "what is in the shadow is subtracted"}}));
    }
    const bool good = sums.passes("the light") && leanings.passes("the light");
    const Color top = light(on_sphere(up), one), hidden = light(ground, one);
    explain_if(top.x <= 0 && hidden.x != 0, "only what is in the shadow is lit");
    explain_if(good && near(hidden.y, 10 * unit),
               "no light is kept off: is_shadowed is missing, or asked from another point or direction");
    if (good && hidden.x == 0) shadows.passes("the light on the sphere, where the rectangle keeps some of it off,");
    std::printf("# digits_of_pi\n%s\n# place red green blue\n", digits_of_pi(sums.given[1] / (10 * unit)));
    const auto print = [](const char* name, Color color) {
        std::printf("%-26s %.6g %.6g %.6g\n", name, color.x, color.y, color.z);
    };
    print("nothing", light(on_sphere(up), {}));
    print("sphere,one_direction", light(on_sphere(up), one));
    print("sphere,slanted", light(on_sphere(slanted), leaning, 0.2));
    print("sphere,four_directions", light(on_sphere(slanted), four, 0.7));
    print("sphere,part_in_the_shadow", light(on_sphere(right), across));
    print("rectangle,in_the_shadow", light(ground, one));
    print("rectangle,from_below", light(below, one));
    print("rectangle,turned", light(below, four, 0.45));
}

}  // namespace

int main(int argc, char** argv) {
    return call(argc, argv, {{"montecarlo", montecarlo}, {"inverse", inverse}, {"z", z}, {"shade", shade}});
}
