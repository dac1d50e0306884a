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

struct Weight {
    double given, n, y;
    double all = 2 * portable::pi;
};

void montecarlo() {
    std::printf(
        "# n directions weights sum_of_weights least_weight largest_weight known directions_are digits_of_pi\n");
    std::vector<Weight> weights;
    for (const std::size_t n : {8u, 1u, 41u}) {
        Random random(n, 0);
        const DirectionSet set = place_directions(Placement::uniform, n, random);
        const QuadratureRule rule = monte_carlo_rule(set);
        if (rule.weights.empty()) throw std::runtime_error("the rule has no weights");
        explain_if(rule.weights.size() != n, "the rule has %zu weights for %zu directions", rule.weights.size(), n);
        double sum = 0, apart = 0;
        for (const double weight : rule.weights) sum += weight;
        for (std::size_t i = 0; i < std::min(n, rule.directions.size()); ++i) {
            apart += squared_distance(rule.directions[i], set.directions[i]);
            if (rule.weights.size() == n)
                weights.push_back({rule.weights[i], static_cast<double>(n), set.directions[i].y});
        }
        const auto [least, largest] = std::minmax_element(rule.weights.begin(), rule.weights.end());
        std::printf("%zu %zu %zu %.9g %.9g %.9g %s %s %s\n", n, rule.directions.size(), rule.weights.size(), sum,
                    *least, *largest, rule.known == Known::nothing ? "nothing" : "cosine",
                    apart > 0 ? "others" : "given", digits_of_pi(sum / (2 * portable::pi)));
        explain_if(rule.directions.size() != n, "the rule has %zu directions, %zu were given", rule.directions.size(),
                   n);
        explain_if(apart > 0, "the rule's directions are not those that were given");
        explain_if(rule.known != Known::nothing, "the known part is the cosine; it has to be nothing");
    }
    using W = const Weight&;
    explain<Weight>(
        weights,
        {{[](W w) { return w.all / w.n; }, nullptr},
         {[](W w) { return w.all / w.n * w.y; }, "cos(theta) is in the weights; they are for any f"},
         {[](W w) { return w.y / w.n; }, "cos(theta) is in the weights; they are for any f"},
         {[](W w) { return w.n / w.all / w.n; }, "weights are not densities: these are divided by 2 pi"},
         {[](W w) { return w.all / w.n * std::sqrt(1 - w.y * w.y); }, "the sine is in the weights; they are for any f"},
         {[](W w) { return w.all / std::sqrt(w.n); }, "the weights are divided by the root of n"},
         {[](W) { return 1.0; }, "every weight is 1: n directions have to share the hemisphere"},
         {[](W w) { return w.all; }, "the weights are not divided by the number of directions"},
         {[](W w) { return w.all / w.n / w.n; }, "the weights are divided by n twice"},
         {[](W w) { return 1 / w.n; }, "the weights add up to 1; the integral of 1 over H is more"},
         {[](W w) { return w.all / (w.n - 1); }, "the weights are divided by n - 1"},
         {[](W w) { return w.all / (w.n + 1); }, "the weights are divided by n + 1"}});
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

void print_refusal(const char* name, bool factor_is_right, double a, double b, double c) {
    Matrix matrix(2, 2);
    matrix(0, 0) = a, matrix(0, 1) = matrix(1, 0) = b, matrix(1, 1) = c;
    try {
        const Cholesky cholesky(matrix);
        std::printf("%s nowhere\n", name);
        explain_if(
            factor_is_right && c > 1 && b == 1,
            "a pivot that is 0 but for rounding is not refused: root_of_pivot wants the a_kk of A, not the pivot");
        explain_if(factor_is_right && (a < 0 || b > a),
                   "a matrix that is not positive definite is not refused: root_of_pivot(k, pivot, a_kk) does that");
    } catch (const NotPositiveDefinite& error) {
        std::printf("%s %zu\n", name, error.index);
    }
}

// Of a matrix Q.
struct Element {
    double given;
    const Covariance& k;
    double r2, noise, scalar;
};

void explain_covariances(const std::vector<Element>& diagonal, const std::vector<Element>& others) {
    using E = const Element&;
    explain<Element>(
        others,
        {{[](E e) { return e.k(e.r2); }, nullptr},
         {[](E e) { return e.k(e.r2) + e.noise * e.noise; },
          "the squared noise is added off the diagonal of Q as well"},
         {[](E e) { return e.k(e.r2) + e.noise; }, "the noise is added off the diagonal of Q as well"},
         {[](E e) { return e.k(std::sqrt(e.r2)); }, "k is given the chord; it takes the squared chord"},
         {[](E e) { return e.k(e.r2 * e.r2); }, "k is given the square of the squared chord"},
         {[](E e) { return e.k(e.r2) * e.noise * e.noise; }, "k is multiplied by the squared noise"},
         {[](E e) { return e.k(0); }, "off its diagonal Q has k(0): the distance of a direction to itself"},
         {[](E e) { return e.k(std::min(4.0, 2 * e.r2)); }, "k is given twice the squared chord"},
         {[](E) { return 0.0; }, "off its diagonal Q has zeros above the diagonal"},
         {[](E e) { return 8.0 / 3 - std::sqrt(e.r2); },
          "Q is made of the kernel 8/3 - r whatever covariance is given"},
         {[](E e) { return e.r2; }, "k is missing: off its diagonal Q has squared chords"},
         {[](E e) { return std::sqrt(e.r2); }, "k is missing: off its diagonal Q has chords"},
         {[](E e) { return e.scalar; }, "k is missing: off its diagonal Q has scalar products"},
         {[](E e) { return e.k(std::acos(e.scalar)); }, "k is given the angle; it takes the squared chord"},
         {[](E e) { return e.k(e.scalar); }, "k is given the scalar product; it takes the squared chord"},
         {[](E e) { return e.k(std::fabs(e.scalar)); }, "k is given the scalar product; it takes the squared chord"},
         {[](E e) { return e.k(1 - e.scalar); }, "k is given half of the squared chord"}});
    explain<Element>(
        diagonal,
        {{[](E e) { return e.k(0) + e.noise * e.noise; }, nullptr},
         {[](E e) { return e.k(0) + e.noise; }, "the diagonal of Q has the noise itself, not its square"},
         {[](E e) { return e.k(0); }, "the noise is missing on the diagonal of Q"},
         {[](E e) { return e.k(0) + 2 * e.noise; }, "the diagonal of Q has twice the noise, not its square"},
         {[](E e) { return e.k(0) + 2 * e.noise * e.noise; }, "the squared noise is added twice on the diagonal of Q"},
         {[](E e) { return e.k(0) + std::sqrt(e.noise); },
          "the diagonal of Q has the root of the noise, not its square"},
         {[](E e) { return e.k(0) - e.noise * e.noise; }, "the squared noise is subtracted on the diagonal of Q"},
         {[](E e) { return e.k(0) * e.noise * e.noise; }, "k is multiplied by the squared noise on the diagonal of Q"},
         {[](E e) { return e.k(0) * (1 + e.noise * e.noise); }, "the noise on the diagonal of Q is multiplied by k"},
         {[](E e) { return 8.0 / 3 + e.noise * e.noise; },
          "Q is made of the kernel 8/3 - r whatever covariance is given"},
         {[](E e) { return e.noise * e.noise; }, "k is missing on the diagonal of Q: k(0) is not 0"},
         {[](E e) { return e.noise; }, "k is missing on the diagonal of Q: k(0) is not 0"},
         {[](E e) { return e.k(e.noise * e.noise); },
          "the squared noise goes into k; it is added to k on the diagonal of Q"},
         {[](E e) { return e.k(0) + e.noise * e.noise * e.noise * e.noise; },
          "the noise is squared twice on the diagonal of Q"},
         {[](E e) { return 1 + e.noise * e.noise; }, "the diagonal of Q has 1 in place of k(0)"}});
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
            const std::pair<double, const char*> mistakes[] = {
                {of(a(k, j)), "nothing is subtracted from a_kj"},
                {of(a(k, j) + sum), "the sum over i < k is added; it is to be subtracted"},
                {of(a(k, j) - sum + last), "the last term of the sum over i < k is missing"},
                {of(a(k, j) - sum + first), "the first term of the sum over i < k is missing"},
                {a(k, j) - sum, diagonal ? "the root is missing" : "the division by u_kk is missing"},
                {(a(k, j) - sum) / (u(k, k) * u(k, k)), "divided by u_kk twice"},
                {(a(k, j) - sum) / a(k, k), "divided by a_kk in place of u_kk"},
                {a(k, j), "this is a_kj still"}};
            const char* words = "";
            for (const auto& [value, its] : mistakes)
                if (!*words && near(u(k, j), value)) words = its;
            explain_if(true, "the factor is right as far as here: k = %zu, j = %zu%s%s", k, j, *words ? ": " : "",
                       words);
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
            double b[3] = {};
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t k = 0; k < 3; ++k) b[i] += a(i, k) * x(k, j);
            explain_if(std::fabs(b[j] - 1) + std::fabs(b[(j + 1) % 3]) + std::fabs(b[(j + 2) % 3]) > 1e-6,
                       "column %zu of A^-1 solves A x = b for b = (%.3g, %.3g, %.3g), which is not e_%zu", j,
                       only_rounding_is_zero(b[0]), only_rounding_is_zero(b[1]), only_rounding_is_zero(b[2]), j);
        }
    }
    std::printf("# n A_times_inverse-1\n");
    for (const std::size_t n : {1u, 2u, 8u, 33u, 41u, 100u})
        std::printf("%zu %.3g\n", n, residual(symmetric(test_matrix(n, 0)), factored(test_matrix(n, 0.1)).inverse()));
    std::printf("# matrix refused_in_row\n");
    print_refusal("positive", right, 1, 0.5, 1);
    print_refusal("negative", right, -1, 0, 1);
    print_refusal("indefinite", right, 1, 2, 1);
    print_refusal("singular", right, 1, 1, 1);
    print_refusal("singular_but_for_rounding", right, 1, 1, 1 + 2.3e-16);
}

// Of a direction, at an azimuth of which nothing depends.
struct Z {
    double given;
    const Covariance& k;
    Vec3 w;
    double n, sum;  // of k of this direction with all

    double of(double cosine) const { return k.z(std::min(1.0, std::max(0.0, cosine))); }
    double right() const { return of(w.y); }
    double sine() const { return std::sqrt(std::max(0.0, 1 - w.y * w.y)); }
    double angle() const { return std::acos(std::min(1.0, w.y)); }
};

void z() {
    const Sobolev sobolev;
    const SquaredExponential other(0.7);
    std::vector<Vec3> directions;
    for (const double cosine : {1 + 1e-15, 1.0, 0.9, 0.5, 0.1, 0.0})
        for (const double turns : {0.0, 0.3})
            directions.push_back(rotate_around_y({std::sqrt(std::max(0.0, 1 - cosine * cosine)), cosine, 0}, turns));
    std::vector<Z> all;
    const auto take = [&](const Covariance& k, const std::vector<Vec3>& its) {
        const std::vector<double> z = z_of(k, its);
        if (z.size() != its.size()) throw std::runtime_error("z should have a number for each direction");
        for (std::size_t i = 0; i < z.size(); ++i) {
            all.push_back({z[i], k, its[i], static_cast<double>(its.size()), 0});
            for (const Vec3& its_j : its) all.back().sum += k(squared_distance(its[i], its_j));
        }
    };
    take(sobolev, directions);
    take(other, directions);
    take(sobolev, fan(100));
    using C = const Z&;
    const bool right = explain<Z>(
        all,
        {{[](C z) { return z.right(); }, nullptr},
         {[](C z) { return z.of(std::fabs(z.w.x)); }, "z was taken of another component than y"},
         {[](C z) { return z.of(std::fabs(z.w.z)); }, "z was taken of another component than y"},
         {[](C z) { return z.of(z.w.x); }, "z was taken of another component than y"},
         {[](C z) { return z.of(z.w.z); }, "z was taken of another component than y"},
         {[](C z) { return z.of(z.sine()); }, "z was taken of the sine in place of the cosine y"},
         {[](C z) { return z.of(z.angle()); }, "z was taken of the angle acos(y) in place of the cosine y"},
         {[](C z) { return z.of(2 / portable::pi * z.angle()); }, "z was taken of the angle in place of the cosine y"},
         {[](C z) { return z.of(1 - 2 / portable::pi * z.angle()); },
          "z was taken of the angle in place of the cosine y"},
         {[](C z) { return z.of(1 - z.w.y); }, "z was taken of 1 - y in place of y"},
         {[](C z) { return z.of(2 - 2 * z.w.y); }, "z was taken of the squared chord to the up axis in place of y"},
         {[](C z) { return z.of(z.w.y / 2); }, "z was taken of y / 2 in place of y"},
         {[](C z) { return 2 * z.right(); }, "z is twice what covariance.z gives"},
         {[](C z) { return z.of(z.w.y * z.w.y); }, "z was taken of y^2 in place of y"},
         {[](C z) { return z.of(1); }, "z does not depend on the elevation"},
         {[](C z) { return z.of(0); }, "z does not depend on the elevation"},
         {[](C z) { return Sobolev().z(std::min(1.0, z.w.y)); },
          "z is always the default covariance's; take the one given"},
         {[](C z) { return z.sum; }, "z is a sum of k over the directions given; it is an integral over H"},
         {[](C z) { return z.sum * 2 * portable::pi / z.n; },
          "z is a mean of k over the directions given; take covariance.z"},
         {[](C z) { return z.of(std::cos(z.w.y)); }, "z was taken of cos(y); y is the cosine already"},
         {[](C z) { return portable::pi * z.w.y; }, "this is pi y, not z: covariance.z gives the integral"},
         {[](C z) { return z.right() / z.n; }, "z is divided by the number of directions"},
         {[](C z) { return z.right() * 2 * portable::pi / z.n; }, "z is multiplied by Monte Carlo's weight"},
         {[](C z) { return z.right() / (2 * portable::pi); }, "z is divided by 2 pi; it is an integral, not a mean"},
         {[](C z) { return z.right() * z.w.y; }, "z is multiplied by cos(theta)"},
         {[](C z) { return z.k(z.w.y); }, "this is k of y, not z: covariance.z gives the integral"},
         {[](C z) { return z.k(1 - z.w.y); }, "this is k, not z: covariance.z gives the integral"},
         {[](C z) { return z.k(2 - 2 * z.w.y); },
          "this is k of the chord to the up axis, not z: covariance.z gives the integral"},
         {[](C z) { return z.w.y; }, "this is y, not z: covariance.z gives the integral"}});
    std::size_t apart = 0, pairs = 0, zeros = 0;
    for (std::size_t i = 4; i < directions.size(); i += 2, ++pairs)
        if (std::fabs(all[i].given - all[i + 1].given) > 1e-9) ++apart;
    for (const Z& each : all) zeros += each.given == 0;
    explain_if(!right && zeros > 0, "%zu of %zu numbers are 0: are they set?", zeros, all.size());
    explain_if(!right && apart == pairs, "z depends on the azimuth; it must not");
    std::printf("# x y z z_j\n");
    for (const Z& z : all) std::printf("%.6f %.6f %.6f %.9g\n", z.w.x, z.w.y, z.w.z, z.given);
}

CosineRule rule_of(std::initializer_list<std::pair<Vec3, double>> directions) {
    CosineRule rule;
    for (const auto& [direction, weight] : directions) rule.add(direction, weight);
    return rule;
}

// Of a rule for pixels.
struct Weighted {
    double given, weight, y, z;
};

void print_cosine_rule() {
    const std::vector<Vec3> directions{{0, 1, 0}, {0.6, 0.8, 0}, {0, 0.8, 0.6}, {0, 0.28, 0.96}};
    const std::vector<double> weights{10, 10, -30, 5};
    const CosineRule rule = cosine_rule({directions, weights});
    std::printf("# elevation_cosine weight\n");
    for (std::size_t i = 0; i < rule.size(); ++i)
        std::printf("%.6g %.6g\n", static_cast<double>(rule.y[i]), rule.weights[i]);
    if (rule.size() != 4) throw std::runtime_error("the rule for a pixel has not as many directions as the rule given");
    std::vector<Weighted> all;
    for (std::size_t i = 0; i < 4; ++i) {
        all.push_back({rule.weights[i], weights[i], directions[i].y, directions[i].z});
        explain_if(squared_distance(Vec3(rule.direction(i)), directions[i]) > 1e-6,
                   "the directions of the rule for a pixel are not those given: they stay, and only weights change");
    }
    using W = const Weighted&;
    explain<Weighted>(
        all,
        {{[](W w) { return w.weight * w.y; }, nullptr},
         {[](W w) { return w.weight * w.y * w.y; }, "cos(theta) is in the weights twice"},
         {[](W w) { return w.weight; }, "cos(theta) is missing in the weights"},
         {[](W w) { return w.y; }, "the weights given are missing: only cos(theta) is there"},
         {[](W w) { return w.weight + w.y; }, "cos(theta) is added to the weights"},
         {[](W w) { return w.weight / w.y; }, "the weights are divided by cos(theta)"},
         {[](W w) { return w.weight * w.z; }, "another component than y is in the weights"},
         {[](W w) { return w.weight * std::sqrt(1 - w.y * w.y); }, "the sine is in the weights in place of cos(theta)"},
         {[](W w) { return w.weight * std::acos(w.y); }, "the angle is in the weights in place of cos(theta)"},
         {[](W w) { return w.weight * std::cos(w.y); }, "cos(y) is in the weights; y is cos(theta) already"},
         {[](W w) { return w.weight * w.y / portable::pi; }, "1 / pi is in the weights"},
         {[](W w) { return std::max(0.0, w.weight * w.y); }, "a negative weight is taken for 0"},
         {[](W w) { return std::fabs(w.weight * w.y); }, "a negative weight has lost its sign"}});
}

// Texels that all differ, brighter than a screen.
EnvironmentMap varied_light() {
    EnvironmentMap light(8, 4);
    for (int y = 0; y < 4; ++y)
        for (int i = 0; i < 24; ++i) light.row(y)[i] = static_cast<float>(20 + 7 * ((y * 24 + i) * 5 % 97));
    return light;
}

// What a pixel reflects by one rule or several, and what the formula has, without the shadow.
struct Light {
    double given;
    Color albedo;
    double sum, seen, behind;  // of weights times radiance; a direction's, and from behind
    double cosine = 0, world = 0, local = 0, own = 0, soft = 0,
           normal = 0;  // of a direction: cosines, and wrong radiances
    double weight = 0, n = 0, first = 0, last = 0, above = 0, squares = 0;  // of all directions
    double right() const { return albedo.y / portable::pi * sum; }
};

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
    // On top of the sphere: sums over the direction up, with these weights.
    std::vector<Light> sums, leanings, shadows;
    const double seen = environment.radiance(up).y, beneath = environment.radiance(down).y;
    const auto add = [&](std::initializer_list<double> weights) {
        CosineRule rule;
        Light all{0, albedo, 0, seen, beneath};
        for (const double weight : weights) {
            rule.add(up, weight);
            all.weight += weight, all.n += 1, all.last = weight * seen, all.above += seen * std::max(0.0, weight);
            all.first = all.n == 1 ? all.last : all.first, all.squares += weight * weight * seen;
        }
        all.sum = all.weight * seen, all.given = light(on_sphere(up), rule).y;
        sums.push_back(all);
    };
    add({10});
    explain_if(light(on_sphere(up), {}).y > 0, "the sum goes on from the call before; it has to begin with 0");
    add({5});
    add({10, 5});
    add({10, 5, -3});
    using L = const Light&;
    bool good = explain<Light>(
        sums,
        {{[](L l) { return l.right(); }, nullptr},
         {[](L) { return 0.0; }, "there is no light on top of the sphere"},
         {[](L l) { return l.sum / portable::pi; }, "the albedo is missing"},
         {[](L l) { return l.right() * portable::pi; }, "1 / pi is missing"},
         {[](L l) { return l.sum; }, "albedo / pi is missing"},
         {[](L l) { return l.right() / portable::pi; }, "the light is divided by pi twice"},
         {[](L l) { return l.right() * portable::pi * portable::pi; }, "the light is multiplied by pi, not divided"},
         {[](L l) { return l.right() * l.albedo.y; }, "the albedo is there twice"},
         {[](L l) { return (l.albedo.x + l.albedo.y + l.albedo.z) / (3 * portable::pi) * l.sum; },
          "every colour has the mean of the albedos"},
         {[](L l) { return l.albedo.x / portable::pi * l.sum; }, "the albedo of red serves for every colour"},
         {[](L l) { return l.right() / 2; }, "the light is divided by 2 pi in place of pi"},
         {[](L l) { return l.right() / 4; }, "the light is divided by 4 pi in place of pi"},
         {[](L l) { return l.right() / (2 * portable::pi); }, "the light is divided by 2 pi once more"},
         {[](L l) { return l.right() * 2 * portable::pi; }, "the light is multiplied by 2 pi; the weights have that"},
         {[](L l) { return l.right() * l.n / l.weight; }, "the weight is missing"},
         {[](L l) { return l.right() / l.weight; }, "the sum is divided by the sum of the weights"},
         {[](L l) { return l.right() / l.n; }, "the sum is divided by the number of directions"},
         {[](L l) { return l.albedo.y / portable::pi * l.weight * l.behind; },
          "the light is looked up behind the surface"},
         {[](L l) { return l.albedo.y / portable::pi * l.weight; }, "bright light is cut off at 1"},
         {[](L l) { return l.albedo.y / portable::pi * l.squares; }, "the weight is there twice"},
         {[](L l) { return l.albedo.y / portable::pi * l.first; },
          "only the first direction counts: return in the loop?"},
         {[](L l) { return l.albedo.y / portable::pi * l.last; }, "only the last direction counts: = in place of +="},
         {[](L l) { return l.albedo.y / portable::pi * l.above; }, "a negative weight brings nothing; it has to count"},
         {[](L l) { return l.albedo.y / portable::pi * (2 * l.above - l.sum); },
          "a negative weight has lost its sign"}});
    // Directions that lean, on a slanted surface whose frame is turned.
    const Frame frame = Frame(slanted).rotated(0.2);
    for (const Vec3 local : {Vec3{0.6, 0.8, 0}, Vec3{0, 0.6, 0.8}, Vec3{-0.48, 0.6, 0.64}}) {
        const Vec3 world = frame.to_world(local);
        const double radiance = environment.radiance(world).y;
        leanings.push_back({light(on_sphere(slanted), rule_of({{local, 10}}), 0.2).y, albedo, 10 * radiance, radiance,
                            environment.radiance(-1.0 * world).y, local.y, world.y, environment.radiance(local).y,
                            environment.radiance(Frame(slanted).to_world(local)).y,
                            environment.interpolated_radiance(world).y, environment.radiance(slanted).y});
    }
    good = good &&
           explain<Light>(
               leanings,
               {{[](L l) { return l.right(); }, nullptr},
                {[](L l) { return l.right() * l.local / l.seen; }, "the light is looked up in the local direction"},
                {[](L l) { return l.right() * l.own / l.seen; }, "the frame is not the one given, which may be turned"},
                {[](L l) { return l.right() * l.soft / l.seen; },
                 "the light is interpolated; radiance(direction) gives it"},
                {[](L l) { return l.right() * l.normal / l.seen; }, "the light is looked up along the normal"},
                {[](L l) { return l.right() * l.behind / l.seen; }, "the light is looked up behind the surface"},
                {[](L l) { return l.right() * l.cosine; }, "cos(theta) is multiplied once more; the weights have it"},
                {[](L l) { return l.right() * l.world; }, "the light is multiplied by y of a direction in the world"},
                {[](L) { return 0.0; }, "light is missing where nothing keeps it off"}});
    const bool lit = light(on_sphere(up), one).x > 0, dark = light(ground, one).x == 0;
    explain_if(!lit && !dark, "only what is in the shadow is lit");
    for (const Vec3 local : {Vec3{-1, 0, 0}, Vec3{0, 0, 1}}) {
        const double radiance = environment.radiance(Frame(right).to_world(local)).y;
        shadows.push_back({light(on_sphere(right), rule_of({{local, 10}})).y, albedo, 10 * radiance, radiance, 0});
    }
    const Color unshadowed = 1 / portable::pi * 10 * (albedo * environment.radiance(up));
    explain_if(good && near(light(on_sphere(up), one).x, albedo.y / albedo.x * unshadowed.x),
               "the albedo of green serves for every colour");
    explain_if(good && near(light(ground, one).y, unshadowed.y),
               "no light is kept off: is_shadowed is missing, or asked from another point or direction");
    if (good && dark)
        explain<Light>(shadows, {{[](L) { return 0.0; }, nullptr},
                                 {[](L l) { return l.right(); }, "on the sphere the rectangle keeps no light off"}});
    std::printf("# digits_of_pi\n%s\n# place red green blue\n", digits_of_pi(sums[0].given / sums[0].right()));
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
