// alone TASK: what the functions of the task montecarlo, inverse, z or shade give by themselves, whatever becomes of
// the others. alone_integral and alone_rules do so for the tasks that need others, on stand-ins of these.
#include "alone.h"

#include "numerics/formatted.h"
#include "quadrature/quadrature.h"
#include "scene/reflection.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

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
    std::printf("# %s, %zu x %zu\n", name, matrix.rows(), matrix.columns());
    for (std::size_t i = 0; i < matrix.rows(); ++i)
        for (std::size_t j = 0; j < matrix.columns(); ++j)
            std::printf("%.9g%c", matrix(i, j), j + 1 < matrix.columns() ? ' ' : '\n');
}

void montecarlo() {
    std::vector<double> weights, counts, cosines;
    for (const std::size_t n : {8u, 1u, 41u}) {
        Random random(n, 0);
        const DirectionSet set = place_directions(Placement::uniform, n, random);
        const QuadratureRule rule = monte_carlo_rule(set);
        if (rule.weights.empty()) throw std::runtime_error("the rule has no weights");
        explain_if(rule.weights.size() != n, "the rule has %zu weights for %zu directions", rule.weights.size(), n);
        explain_if(rule.directions.size() != n, "the rule has %zu directions, %zu were given", rule.directions.size(),
                   n);
        bool same = true;
        for (std::size_t i = 0; i < std::min({n, rule.directions.size(), rule.weights.size()}); ++i) {
            same = same && squared_distance(rule.directions[i], set.directions[i]) == 0;
            weights.push_back(rule.weights[i]), counts.push_back(static_cast<double>(n)),
                cosines.push_back(set.directions[i].y);
        }
        explain_if(std::count(rule.weights.begin(), rule.weights.end(), 0.0) > 0, "a weight is 0: is it set?");
        explain_if(!same, "the rule's directions are not those that were given");
        explain_if(rule.known != Known::nothing, "the known part is the cosine; it has to be nothing");
        const char* digits = digits_of_pi(rule.weights[0] * static_cast<double>(n) / (2 * pi));
        std::printf("# n directions weights known directions_are digits_of_pi\n%zu %zu %zu %s %s %s\n# weight\n", n,
                    rule.directions.size(), rule.weights.size(), rule.known == Known::nothing ? "nothing" : "cosine",
                    same ? "given" : "others", digits);
        for (const double weight : rule.weights) std::printf("%.9g\n", weight);
    }
    explain("a weight", weights, [&](std::size_t i) {
        const double n = counts[i], y = cosines[i];
        return mistakes(2 * pi / n, {{{y / n}, " is cos(theta) / n"}, {{1 / (2 * pi)}, " is a density, 1 / (2 pi)"}}, n,
                        y);
    });
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
    struct {
        const char* name;
        double a, b, c;
    } const all[] = {{"positive", 1, 0.5, 1},
                     {"negative", -1, 0, 1},
                     {"indefinite", 1, 2, 1},
                     {"singular", 1, 1, 1},
                     {"singular_but_for_rounding", 1, 1, 1 + 2.3e-16}};
    for (const auto& [name, a, b, c] : all) {
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

// Of a matrix Q.
struct Element {
    double given;
    const Covariance& k;
    double r2, noise, scalar;
};

std::vector<double> given(const std::vector<Element>& elements) {
    std::vector<double> given;
    for (const Element& e : elements) given.push_back(e.given);
    return given;
}

void explain_covariances(const std::vector<Element>& diagonal, const std::vector<Element>& others) {
    constexpr const char* own = "Q is made of the kernel 8/3 - r whatever covariance is given";
    explain("off its diagonal Q", given(others), [&](std::size_t i) {
        const Element& e = others[i];
        const double right = e.k(e.r2), r = std::sqrt(e.r2), square = e.noise * e.noise;
        return mistakes(
            right,
            {{{right + square}, "the squared noise is added off the diagonal of Q as well"},
             {{right + e.noise}, "the noise is added off the diagonal of Q as well"},
             {{e.k(r)}, "k is given the chord; it takes the squared chord"},
             {{right * square}, " is multiplied by the squared noise"},
             {{e.k(0)}, " has k(0): the distance of a direction to itself"},
             {{e.k(1 - e.scalar), e.k(std::min(4.0, 2 * e.r2))}, "k is given half of the squared chord, or twice"},
             {{8.0 / 3 - r}, own},
             {{e.r2, r, e.scalar}, " has squared chords, chords or scalar products: k is missing"},
             {{e.k(std::acos(e.scalar))}, "k is given the angle; it takes the squared chord"},
             {{e.k(e.scalar), e.k(std::fabs(e.scalar))}, "k is given the scalar product; it takes the squared chord"}});
    });
    explain("the diagonal of Q", given(diagonal), [&](std::size_t i) {
        const double noise = diagonal[i].noise, k = diagonal[i].k(0), square = noise * noise;
        return mistakes(
            k + square,
            {{{k + noise, k + 2 * noise, k + std::sqrt(noise)}, " has the noise itself, or its root, not its square"},
             {{k}, "the noise is missing on the diagonal of Q"},
             {{k * square, k + k * square, k - square, k + 2 * square, k + square / 2},
              " has the squared noise multiplied by k, subtracted, twice or half"},
             {{8.0 / 3 + square}, own},
             {{square, noise}, " lacks k: k(0) is not 0"},
             {{diagonal[i].k(square)}, "the squared noise goes into k; it is added to k on the diagonal of Q"},
             {{1 + square}, " has 1 in place of k(0)"}});
    });
    for (const Element& e : others)
        explain_if(std::fabs(e.given - e.k(e.r2)) > 1e-12 && near(e.given, e.k(e.r2)),
                   "Q is rounded to float; it has to be double");
}

// The first element of U that is wrong where those before it are right; whether there is none.
bool explain_factor(const Matrix& a, const Matrix& u) {
    for (std::size_t k = 0; k < a.rows(); ++k)
        for (std::size_t j = k; j < a.rows(); ++j) {
            double sum = 0;
            for (std::size_t i = k; i-- > 0;) sum += u(i, k) * u(i, j);
            const bool diagonal = j == k;
            const double last = k > 0 ? u(k - 1, k) * u(k - 1, j) : 0, first = k > 0 ? u(0, k) * u(0, j) : 0;
            const auto of = [&](double rest) { return diagonal ? std::sqrt(rest) : rest / u(k, k); };
            if (near(u(k, j), of(a(k, j) - sum))) continue;
            const double rest = a(k, j) - sum;
            const std::string about = formatted("the factor is right as far as here: k = %zu, j = %zu", k, j);
            explain(about, {u(k, j)}, [&](std::size_t) {
                return Mistakes{{{of(rest)}, ""},
                                {{of(a(k, j))}, ": nothing is subtracted from a_kj"},
                                {{of(a(k, j) + sum)}, ": the sum over i < k is added; it is to be subtracted"},
                                {{of(rest + last), of(rest + first)},
                                 ": the first or the last term of the sum over i < k is missing"},
                                {{rest}, diagonal ? ": the root is missing" : ": the division by u_kk is missing"},
                                {{rest / (u(k, k) * u(k, k)), rest / a(k, k)}, ": divided by u_kk twice, or by a_kk"},
                                {{a(k, j)}, ": this is a_kj still"}};
            });
            explain_if(true, "%s", about.c_str());
            return false;
        }
    return true;
}

void inverse() {
    const Sobolev sobolev;
    const SquaredExponential other(0.7);
    const std::vector<Vec3> nine = fan(9);
    std::vector<Element> diagonal, others;
    const auto print_q = [&](const char* name, const Covariance& k, double noise, const std::vector<Vec3>& directions) {
        const Matrix q = covariance_matrix(k, noise, directions);
        if (q.rows() != directions.size() || q.columns() != directions.size())
            throw std::runtime_error("Q needs a row and a column for each direction");
        print_matrix(name, symmetric(q));
        for (std::size_t i = 0; i < q.rows(); ++i)
            for (std::size_t j = i; j < q.rows(); ++j)
                (i == j ? diagonal : others)
                    .push_back({q(i, j), k, squared_distance(directions[i], directions[j]), noise,
                                dot(directions[i], directions[j])});
        std::printf("# digits lost\n%.3g\n",
                    only_rounding_is_zero(q(0, 1) - k(squared_distance(directions[0], directions[1]))));
    };
    for (const std::vector<Vec3>& directions : {fan(3), fan(5), std::vector<Vec3>(nine.begin() + 6, nine.end())})
        print_q("Q of directions", sobolev, 0.3, directions);
    print_q("Q of another covariance", other, 0.1, fan(4));
    explain_covariances(diagonal, others);
    const Matrix a = symmetric(test_matrix(3, 0));
    const Cholesky cholesky = factored(test_matrix(3, 0.1));
    const Matrix u = cholesky.upper(), x = cholesky.inverse();
    print_matrix("U", u);
    const Matrix same = factored(test_matrix(3, 0)).upper();
    const bool reads = !near(u(0, 1), same(0, 1)) || !near(u(1, 2), same(1, 2));
    explain_if(reads, "the factor reads the lower triangle of A, of which nothing counts");
    const bool right = explain_factor(a, u);
    print_matrix("A^-1", x);
    if (right && residual(a, x) > 0 && x.rows() == 3 && x.columns() == 3) {
        const std::vector<double> half = cholesky.solve_lower({1, 0, 0});
        explain_if(near(x(1, 0), half[1]) && near(x(2, 0), half[2]),
                   "its columns are those of solve_lower; take solve");
        explain_if(residual(u, x) == 0, "this is the inverse of U, not of A");
        for (std::size_t j = 0; j < 3; ++j) {
            const double e[3] = {error(a, x, 0, j), error(a, x, 1, j), error(a, x, 2, j)};
            explain_if(e[0] != 0 || e[1] != 0 || e[2] != 0,
                       "column %zu of A^-1 solves A x = b for b = e_%zu + (%.3g, %.3g, %.3g), not e_%zu", j, j, e[0],
                       e[1], e[2], j);
        }
    }
    std::printf("# n A_times_inverse-1\n");
    for (const std::size_t n : {1u, 2u, 8u, 33u, 41u, 100u})
        std::printf("%zu %.3g\n", n, residual(symmetric(test_matrix(n, 0)), factored(test_matrix(n, 0.1)).inverse()));
    print_refusals(right);
}

// Of a direction, at an azimuth of which nothing depends.
struct Z {
    const Covariance& k;
    Vec3 w;
    double n, sum;  // of k of this direction with all
};

void z() {
    const Sobolev sobolev;
    const SquaredExponential other(0.7);
    std::vector<Vec3> directions;
    for (const double cosine : {1 + 1e-15, 1.0, 0.9, 0.5, 0.1, 0.0})
        for (const double turns : {0.0, 0.3})
            directions.push_back(rotate_around_y({std::sqrt(std::max(0.0, 1 - cosine * cosine)), cosine, 0}, turns));
    std::vector<Z> all;
    std::vector<double> given;
    const auto take = [&](const Covariance& k, const std::vector<Vec3>& its) {
        const std::vector<double> z = z_of(k, its);
        if (z.size() != its.size()) throw std::runtime_error("z should have a number for each direction");
        for (std::size_t i = 0; i < z.size(); ++i) {
            given.push_back(z[i]), all.push_back({k, its[i], static_cast<double>(its.size()), 0});
            for (const Vec3& its_j : its) all.back().sum += k(squared_distance(its[i], its_j));
        }
    };
    take(sobolev, directions);
    take(other, directions);
    take(sobolev, fan(100));
    const bool good = explain("z", given, [&](std::size_t i) {
        const Z& z = all[i];
        const auto of = [&](double cosine) { return z.k.z(std::min(1.0, std::max(0.0, cosine))); };
        const double y = std::min(1.0, z.w.y), quarters = 2 / pi * std::acos(y);
        return mistakes(
            of(y),
            {{{of(std::fabs(z.w.x)), of(std::fabs(z.w.z)), of(z.w.x), of(z.w.z)},
              " was taken of another component than y"},
             {{of(std::sqrt(1 - y * y))}, " was taken of the sine in place of the cosine y"},
             {{of(std::acos(y)), of(quarters), of(1 - quarters)}, " was taken of the angle in place of the cosine y"},
             {{of(std::cos(y)), of(1 - y), of(2 - 2 * y), of(y * y), of(y / 2)},
              " was taken of cos(y), 1 - y, 2 - 2 y, y^2 or y / 2; take y, which is the cosine"},
             {{of(1), of(0)}, " does not depend on the elevation"},
             {{Sobolev().z(y)}, " is always the default covariance's; take the one given"},
             {{z.sum, z.sum * 2 * pi / z.n}, " is a sum of k over the directions given; it is an integral over H"},
             {{y, pi * y}, "this is y or pi y, not z: covariance.z gives the integral"},
             {{z.k(y), z.k(1 - y), z.k(2 - 2 * y)}, "this is k of y, not z: covariance.z gives the integral"}},
            z.n, y);
    });
    std::size_t apart = 0, pairs = 0;
    for (std::size_t i = 4; i < directions.size(); i += 2, ++pairs)
        if (std::fabs(given[i] - given[i + 1]) > 1e-9) ++apart;
    const auto zeros = static_cast<std::size_t>(std::count(given.begin(), given.end(), 0.0));
    explain_if(!good && zeros > 0, "%zu of %zu numbers are 0; z is not", zeros, all.size());
    explain_if(!good && apart == pairs, "z depends on the azimuth; it must not");
    explain_if(!good && given[0] == given[11], "z does not depend on the elevation");
    std::printf("# x y z z_j\n");
    for (std::size_t i = 0; i < all.size(); ++i)
        std::printf("%.6f %.6f %.6f %.9g\n", all[i].w.x, all[i].w.y, all[i].w.z, given[i]);
}

CosineRule rule_of(std::initializer_list<std::pair<Vec3, double>> directions) {
    CosineRule rule;
    for (const auto& [direction, weight] : directions) rule.add(direction, weight);
    return rule;
}

void print_cosine_rule() {
    const std::vector<Vec3> directions{{0.6, 0.8, 0}, {0, 1, 0}, {0, 0.8, 0.6}, {0, 0.28, 0.96}};
    const std::vector<double> weights{10, 10, -30, 5};
    const CosineRule rule = cosine_rule({directions, weights});
    std::printf("# elevation_cosine weight\n");
    for (std::size_t i = 0; i < rule.size(); ++i)
        std::printf("%.6g %.6g\n", static_cast<double>(rule.y[i]), rule.weights[i]);
    if (rule.size() != 4) throw std::runtime_error("the rule for a pixel has not as many directions as the rule given");
    for (std::size_t i = 0; i < 4; ++i)
        explain_if(squared_distance(Vec3(rule.direction(i)), directions[i]) > 1e-6,
                   "the directions of the rule for a pixel are not those given: they stay, and only weights change");
    explain("a weight of the rule for a pixel", rule.weights, [&](std::size_t i) {
        const double weight = weights[i], y = directions[i].y;
        return mistakes(weight * y,
                        {{{y}, " is cos(theta): the weights given are missing"},
                         {{0.8 * weight}, " has the cosine of the first direction, whichever it is of"},
                         {{weight * weight * y}, " is squared"},
                         {{weight + y}, " has cos(theta) added to it"},
                         {{weight * std::sqrt(1 - y * y)}, " has the sine in place of cos(theta)"},
                         {{weight * std::acos(y), weight * std::cos(y), weight * directions[i].z, weight * (1 - y)},
                          " has the angle, cos(y), 1 - y or z in it; y is cos(theta)"}},
                        NAN, y);
    });
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
    const std::vector<double> lists[] = {{10}, {5}, {10, 5}, {10, 5, -3}};
    std::vector<double> sums, leanings, shadows;
    const double nothing = light(on_sphere(up), {}).y;
    for (const std::vector<double>& weights : lists) {
        CosineRule rule;
        for (const double weight : weights) rule.add(up, weight);
        sums.push_back(light(on_sphere(up), rule).y);
    }
    explain_if(nothing > 0,
               "a rule without directions reflects light: what is added to the sum, or stands in its place?");
    explain_if(light(on_sphere(up), {}).y > nothing, "the sum goes on from the call before; it has to begin with 0");
    const double seen = environment.radiance(up).y, unit = albedo.y / pi * seen;  // of light, by the weight 1
    const auto of_sum = [&](std::size_t i) {
        std::vector<double> terms;
        for (const double weight : lists[i]) terms.push_back(unit * weight);
        const double n = static_cast<double>(terms.size()),
                     sum = std::accumulate(lists[i].begin(), lists[i].end(), 0.0);
        const double squares = std::inner_product(lists[i].begin(), lists[i].end(), lists[i].begin(), 0.0);
        return mistakes(terms,
                        {{{0},
                          "there is no light on top of the sphere: is it lit where is_shadowed says so, or asked about "
                          "another direction?"},
                         {{seen * sum / pi}, "the albedo is missing"},
                         {{seen * sum}, "albedo / pi is missing"},
                         {{unit * sum * albedo.y}, "the albedo is there twice"},
                         {{albedo.x / pi * seen * sum, (albedo.x + albedo.y + albedo.z) / (3 * pi) * seen * sum},
                          "the albedo of red, or their mean, serves for every colour"},
                         {{unit * n}, "the weight is missing"},
                         {{unit}, " is divided by the sum of the weights"},
                         {{albedo.y / pi * sum * environment.radiance(down).y}, " is looked up behind the surface"},
                         {{albedo.y / pi * sum}, "bright light is cut off at 1"},
                         {{unit * squares}, "the weight is there twice"},
                         {{unit * sum * seen}, "the radiance is squared"}});
    };
    // Directions that lean, on a slanted surface whose frame is turned.
    const Frame frame = Frame(slanted).rotated(0.2);
    const Vec3 leans[] = {{0.6, 0.8, 0}, {0, 0.6, 0.8}, {-0.48, 0.6, 0.64}}, hides[] = {{-1, 0, 0}, {0, 0, 1}};
    for (const Vec3 local : leans) leanings.push_back(light(on_sphere(slanted), rule_of({{local, 10}}), 0.2).y);
    for (const Vec3 local : hides) shadows.push_back(light(on_sphere(right), rule_of({{local, 10}})).y);
    const auto of_leaning = [&](std::size_t i) {
        const auto from = [&](Vec3 direction) { return albedo.y / pi * 10 * environment.radiance(direction).y; };
        const Vec3 world = frame.to_world(leans[i]);
        return mistakes(
            from(world),
            {{{from(leans[i])}, " is looked up in the local direction"},
             {{from(Frame(slanted).to_world(leans[i]))}, "the frame is not the one given, which may be turned"},
             {{albedo.y / pi * 10 * environment.interpolated_radiance(world).y},
              " is interpolated; radiance(direction) gives it"},
             {{from(slanted)}, " is looked up along the normal"},
             {{from(-1.0 * world)}, " is looked up behind the surface"},
             {{from(world) * world.y}, " is multiplied by y of a direction in the world"},
             {{0}, " is missing where nothing keeps it off"}},
            1, leans[i].y);
    };
    const bool good = explain("the light", sums, of_sum) && explain("the light", leanings, of_leaning);
    const Color top = light(on_sphere(up), one), hidden = light(ground, one);
    explain_if(top.x <= 0 && hidden.x != 0, "only what is in the shadow is lit");
    explain_if(good && near(top.x, 10 * unit / seen * environment.radiance(up).x),
               "the albedo of green serves for every colour");
    explain_if(good && near(hidden.y, 10 * unit),
               "no light is kept off: is_shadowed is missing, or asked from another point or direction");
    if (good && hidden.x == 0)
        explain("", shadows, [&](std::size_t i) {
            const double lit = albedo.y / pi * 10 * environment.radiance(Frame(right).to_world(hides[i])).y;
            return Mistakes{
                {{0}, ""},
                {{lit}, "on the sphere the rectangle keeps no light off: is_shadowed asked by another direction?"}};
        });
    std::printf("# digits_of_pi\n%s\n# place red green blue\n", digits_of_pi(sums[0] / (10 * unit)));
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
