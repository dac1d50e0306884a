// check_tasks TASK SEED [values] calls the functions of a task on small inputs, which follow from the seed. Of each
// that is wrong it prints a line: the function, the input, what came and what is right. Exit status: 0 right, 1 wrong.
// "values": it prints in the end every number that came, so that a grade need not trust the exit status.
#include "experiments/error_table.h"
#include "scene/render.h"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <map>
#include <set>

#if __has_include(<execinfo.h>)
#include <execinfo.h>
#include <unistd.h>
#endif

using namespace bmc;
using portable::pi;
using Directions = std::vector<Vec3>;
using Numbers = std::vector<double>;

namespace {

std::uint64_t seed = 1;
std::string function;                   // the one that is tried
std::set<std::string> wrong_functions;  // those before it that were wrong
std::string values;                     // every number that came

struct Wrong {};

// Says it, and ends the trial of this function.
[[noreturn]] void wrong(const std::string& words) {
    std::cout << "wrong: " << function << ": " << words << std::endl;
    throw Wrong();
}

// Whether two numbers are the same but for rounding.
bool same(double a, double b, double tolerance = 1e-6) { return std::fabs(a - b) <= tolerance * std::fabs(b) + 1e-12; }

// Whether f throws such an exception.
template <class Exception, class Function>
bool throws(Function f) {
    try {
        f();
        return false;
    } catch (const Exception&) {
        return true;
    }
}

// A plain relation between two numbers, if there is one.
std::string relation(double came, double right, double n) {
    if (!std::isfinite(came) || !std::isfinite(right) || right == 0 || came == 0) return "";
    const std::pair<const char*, double> factors[] = {{"the other sign", -1},
                                                      {"half of it", 0.5},
                                                      {"twice it", 2},
                                                      {"pi times it", pi},
                                                      {"it over pi", 1 / pi},
                                                      {"2 pi times it", 2 * pi},
                                                      {"it over 2 pi", 0.5 / pi},
                                                      {"n times it", n},
                                                      {"it over n", 1 / n},
                                                      {"n / (n - 1) times it", n / (n - 1)}};
    for (const auto& [words, factor] : factors)
        if (std::isfinite(factor) && same(came, factor * right)) return std::string(" (") + words + ")";
    if (same(came, right * right)) return " (its square)";
    return same(came, std::sqrt(std::fabs(right))) ? " (its root)" : "";
}

// What a number is if a common mistake was made, and the mistake.
using Causes = std::vector<std::pair<double, const char*>>;

// The number that came has to be the right one. n: the number of samples or estimates, for a factor of n.
void expect(const std::string& what, double came, double right, double n = 1, double tolerance = 1e-6,
            const Causes& causes = {}) {
    values += formatted("%.9g\n", came);
    if (same(came, right, tolerance)) return;
    std::string why = relation(came, right, n);
    for (const auto& [number, cause] : causes)
        if (same(came, number, tolerance) && came != 0) why = std::string(": ") + cause;
    wrong(what + formatted(" is %.9g, right is %.9g", came, right) + why);
}
void expect_size(const std::string& in, const char* what, std::size_t came, std::size_t right) {
    expect(in + "the number of " + what, static_cast<double>(came), static_cast<double>(right));
}

double real(std::size_t n) { return static_cast<double>(n); }
std::string text(Vec3 v) { return formatted("(%.4g, %.4g, %.4g)", v.x, v.y, v.z); }

void expect_direction(const std::string& what, Vec3 came, Vec3 right,
                      const std::vector<std::pair<Vec3, const char*>>& causes = {}) {
    for (const double each : {came.x, came.y, came.z}) values += formatted("%.6f\n", each + 2);  // no rounded 0
    if (length(came - right) <= 1e-6) return;
    std::string why;
    for (const auto& [vector, cause] : causes)
        if (length(came - vector) <= 1e-6) why = std::string(": ") + cause;
    wrong(what + " is " + text(came) + ", right is " + text(right) + why);
}

const Sobolev sobolev;
const GeneralSobolev rougher(1.4);
const SquaredExponential smooth(0.4);
const std::pair<const char*, const Covariance*> covariances[] = {
    {"Sobolev 1.5", &sobolev}, {"Sobolev 1.4", &rougher}, {"squared exponential 0.4", &smooth}};

// The samples of the trials: few, for which 1, n and 1 / n differ; and many.
constexpr std::size_t sizes[] = {3, 1, 41, 60};

Directions directions_of(std::size_t n) {
    Random random(seed, n);
    return random_directions(n, random);
}

// ---- montecarlo

void monte_carlo_rule_is_right() {
    for (const Density density : {Density::uniform, Density::cosine})
        for (const std::size_t n : sizes) {
            const Directions directions = directions_of(n);
            const QuadratureRule rule = monte_carlo_rule({directions, density});
            const std::string in =
                formatted(density == Density::uniform ? "n = %zu: " : "n = %zu, density cos(theta) / pi: ", n);
            const double right = (density == Density::cosine ? 1 : 2) * std::acos(-1) / real(n);
            expect_size(in, "directions", rule.directions.size(), n);
            expect_size(in, "weights", rule.weights.size(), n);
            for (std::size_t i = 0; i < n; ++i) {
                expect_direction(in + formatted("direction %zu", i), rule.directions[i], directions[i]);
                expect(in + formatted("weight %zu", i), rule.weights[i], right, real(n), 1e-9);  // not of a float
            }
            if ((rule.known == Known::cosine) != (density == Density::cosine))
                wrong(in + "the rule's known part should be this density");
        }
}

// ---- inverse

void covariance_matrix_is_right() {
    for (const auto& [name, covariance] : covariances)
        for (const std::size_t n : sizes) {
            const Covariance& k = *covariance;
            const double noise = n == 3 ? 0.3 : 0.01;
            const double diagonal = std::max(1e-7, 1 - k.k(1e-15) / k.k(0));  // 2 - 2 w.w may be 1e-15, not 0
            Directions w = directions_of(n);
            if (n == 41) w[7] = w[0];
            const Matrix q = covariance_matrix(k, noise, w);
            const std::string in = formatted("%s, noise %g, n = %zu: ", name, noise, n);
            expect_size(in, "elements", q.rows() * q.columns(), n * n);
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < n; ++j) {
                    const double chord = length(w[i] - w[j]), right = k.k(chord * chord) + (i == j ? noise * noise : 0);
                    const std::string what = in + formatted("Q(%zu, %zu)", i, j);
                    const Causes causes = {
                        {i == j ? NAN : k.k(chord), "that is k(chord), and k takes a squared chord"},
                        {i == j ? k.k(0) + noise : NAN, "the noise is added, and its square should be"}};
                    expect(what, q(i, j), right, real(n), chord > 0 ? 1e-9 : diagonal, causes);  // a float is too short
                }
        }
}

void equal_directions_have_equal_rows() {
    const Matrix q = covariance_matrix(sobolev, 0, {{0, 1, 0}, {0, 1, 0}});
    if (q(0, 0) != q(0, 1) || q(1, 0) != q(1, 1))
        wrong(formatted("noise 0, (0, 1, 0) twice: Q(0, 0) is %.17g and Q(0, 1) is %.17g, and they should be equal",
                        q(0, 0), q(0, 1)));
}

// A symmetric positive definite matrix whose smallest eigenvalue is so small that the digits of a float would be lost.
Matrix positive_matrix(std::size_t n) {
    Random random(seed, 1000 + n);
    Matrix b(n, n), a(n, n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) b(i, j) = random.uniform();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            a(i, j) = i == j ? 1e-4 : 0;
            for (std::size_t l = 0; l < n; ++l) a(i, j) += b(i, l) * b(j, l);
        }
    return a;
}

void upper_factor_is_right() {
    for (const std::size_t n : sizes) {
        const std::string in = formatted("n = %zu: ", n);
        const Matrix a = positive_matrix(n);
        Matrix u(0, 0);
        try {
            u = Cholesky(a).upper();
        } catch (const NotPositiveDefinite& refused) {
            wrong(in + "a positive definite matrix is refused: " + refused.what());
        }
        expect_size(in, "elements", u.rows() * u.columns(), n * n);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < i; ++j)
                expect(in + formatted("below the diagonal, u(%zu, %zu)", i, j), u(i, j), 0);
            for (std::size_t j = i; j < n; ++j) {
                double product = 0;
                for (std::size_t l = 0; l <= i; ++l) product += u(l, i) * u(l, j);
                expect(in + formatted("with u up to row %zu, column %zu, (U^T U)(%zu, %zu)", i, j, i, j), product,
                       a(i, j), real(n), 1e-9);
            }
            if (u(i, i) < 0) wrong(in + formatted("u(%zu, %zu) is negative", i, i));
        }
    }
    for (const double last : {0.5, 1 + 2 * DBL_EPSILON}) {  // a pivot below 0, and one of two roundings
        Matrix refused(2, 2);
        refused(0, 0) = 4, refused(0, 1) = refused(1, 0) = 2, refused(1, 1) = last;
        if (!throws<NotPositiveDefinite>([&] { Cholesky{refused}; }))
            wrong("a matrix that is not positive definite is accepted: root_of_pivot refuses it");
    }
}

void inverse_is_right() {
    if (wrong_functions.count("upper_factor")) return;
    for (const std::size_t n : sizes) {
        const Matrix a = positive_matrix(n), inverse = Cholesky(a).inverse();
        const std::string in = formatted("n = %zu: ", n);
        expect_size(in, "elements", inverse.rows() * inverse.columns(), n * n);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) {
                double product = 0;
                for (std::size_t l = 0; l < n; ++l) product += a(i, l) * inverse(l, j);
                if (!(std::fabs(product - (i == j)) <= 1e-6))
                    wrong(in + formatted("(A A^-1)(%zu, %zu) is %.6g, right is %d", i, j, product, i == j));
                values += formatted("%.6f\n", inverse(i, j));
            }
    }
}

// ---- z

void z_of_is_right() {
    const SobolevKnownCosine known_cosine;
    for (const auto& [name, covariance] : covariances)
        for (const std::size_t n : sizes) {
            const Covariance& k = covariance == &sobolev && n == 60 ? known_cosine : *covariance;
            Directions w = directions_of(n);
            if (n == 41) w.insert(w.end(), {{0, 1 + 4e-16, 0}, {1, 0, 0}, {0, 1, 0}});
            const Numbers z = z_of(k, w);
            expect_size(name + std::string(": "), "z", z.size(), w.size());
            for (std::size_t i = 0; i < w.size(); ++i) {
                const double cosine = std::min(1.0, w[i].y), angle = std::acos(cosine);
                const std::string what = name + (": z of the direction " + text(w[i])) +
                                         (k.known() == Known::cosine ? " with the known part cosine" : "");
                expect(what, z[i], k.z(cosine), real(w.size()), 1e-9,
                       {{angle <= 1 ? k.z(angle) : NAN, "that is z(angle), and z takes the cosine, y"},
                        {k.k(cosine), "that is k(y), not z(y)"}});
            }
        }
    if (!throws<std::invalid_argument>([] { z_of(sobolev, {{0.6, -0.8, 0}}); }))
        wrong("a direction below the horizon is accepted: Covariance::z refuses its y");
}

// ---- integral

// Calls f(in, covariance, process) for processes of several sizes.
template <class Function>
void for_each_process(Function f) {
    for (const auto& [name, k] : covariances)
        for (const std::size_t n : sizes) {
            const double noise = n == 3 ? 0.3 : 0.02;
            f(formatted("%s, noise %g, n = %zu: ", name, noise, n), *k, GaussianProcess(*k, noise, directions_of(n)));
        }
}

void bayesian_weights_is_right() {
    for_each_process([](const std::string& in, const Covariance&, const GaussianProcess& process) {
        const Numbers &z = process.z(), &w = process.weights(), half = process.cholesky().forward_substitution(z);
        const Matrix inverse = process.inverse_covariance();
        expect_size(in, "weights", w.size(), z.size());
        for (std::size_t i = 0; i < z.size(); ++i) {
            double right = 0;
            for (std::size_t j = 0; j < z.size(); ++j) right += inverse(i, j) * z[j];
            const double many = z.size() > 1 ? 1 : NAN;
            expect(in + formatted("weight %zu", i), w[i], right, real(z.size()), 1e-6,
                   {{many * half[i], "that is half a solution: of L y = z and U w = y only y"},
                    {many * z[i], "that is z: Q^-1 is missing"}});
        }
    });
}

void posterior_variance_is_right() {
    for_each_process([](const std::string& in, const Covariance& k, const GaussianProcess& process) {
        if (wrong_functions.count("bayesian_weights")) return;
        double right = k.zz();
        for (std::size_t i = 0; i < process.z().size(); ++i) right -= process.weights()[i] * process.z()[i];
        expect(in + "the variance", process.variance(), right, real(process.z().size()));
    });
    Random random(seed, 8);
    for (int i = 0; i < 2000; ++i) {  // three samples determine so smooth a function, and rounding makes some negative
        const SquaredExponential k(1e6);
        try {
            const double variance = GaussianProcess(k, 0, random_directions(3, random)).variance();
            if (!(variance >= 0))
                wrong(formatted("squared exponential 1e+06, n = 3: it is %.3g by rounding, right is 0", variance));
        } catch (const NotPositiveDefinite&) {
        }
    }
}

void integral_is_right() {
    for_each_process([](const std::string& in, const Covariance&, const GaussianProcess& process) {
        if (wrong_functions.count("bayesian_weights")) return;
        Random random(seed, 7);
        double right = 0;
        Numbers y;
        for (const double w : process.weights()) {
            y.push_back(3 * random.uniform() - 1);
            right += w * y.back();
        }
        expect(in + "the estimate", process.integral(y), right, real(y.size()), 1e-8);
    });
}

// ---- table

// Calls f(in, settings, integrand, number of samples).
template <class Function>
void for_each_row(Function f) {
    const Integrand integrands[] = {{"", "cos(theta)^2", [](Vec3 w) { return w.y * w.y; }, 2 * pi / 3},
                                    {"", "1 + x", [](Vec3 w) { return 1 + w.x; }, 2 * pi}};
    for (const Integrand& integrand : integrands)
        for (const std::size_t n : {3u, 41u, 60u}) {
            ErrorSettings settings;
            settings.seed = seed, settings.noise = n == 3 ? 0.3 : 0.05;
            settings.mc_estimates = n == 3 ? 7 : n == 41 ? 4 : 300, settings.bmc_estimates = n == 3 ? 5 : 6;
            if (n == 3) settings.covariance = CovarianceFamily::squared_exponential;
            if (n == 41) settings.placement = Placement::cosine;
            if (n == 60) settings.known = Known::cosine;
            const char* const with = n == 3 ? "" : n == 41 ? ", placement cosine" : ", known cosine";
            f("of " + integrand.formula + formatted(" with n = %zu%s: ", n, with), settings, integrand, n);
        }
}

void expect_errors(const std::string& what, const Statistics& came, const Statistics& right) {
    expect("the number of " + what, came.count, right.count);
    expect("the mean of " + formatted("%g ", right.count) + what, came.mean, right.mean, right.count);
    expect("the standard error of " + what, came.standard_error(), right.standard_error(), right.count);
}

void add_mc_errors_is_right() {
    for_each_row([](const std::string& in, const ErrorSettings& settings, const Integrand& f, std::size_t n) {
        Statistics right;
        for (std::size_t e = 0; right.count < real(settings.mc_estimates); ++e)
            right.add(std::fabs(estimate(monte_carlo_rule(directions_of_estimate(settings, n, e)), f) - f.truth));
        expect_errors("errors " + in + "mc", error_rows({f}, n, settings)[0].mc, right);
    });
}

void add_bmc_errors_is_right() {
    for_each_row([](const std::string& in, const ErrorSettings& settings, const Integrand& f, std::size_t n) {
        Statistics errors, predicted;
        for (std::size_t e = 0; predicted.count < real(settings.bmc_estimates); ++e) {
            const GaussianProcess process(*settings.make_covariance(), settings.noise,
                                          directions_of_estimate(settings, n, e).directions);
            const Numbers y = evaluate(f, process.directions(), settings.known);
            errors.add(std::fabs(process.integral(y) - f.truth));
            predicted.add(process.standard_error(y) * std::sqrt(2 / pi));
        }
        const ErrorRow row = error_rows({f}, n, settings)[0];
        if (!row.refusal.empty()) wrong(in + row.refusal);
        expect_errors("errors " + in + "bmc", row.bmc, errors);
        expect_errors("predicted errors " + in + "predicted", row.predicted, predicted);
    });
    ErrorSettings singular;
    singular.covariance = CovarianceFamily::squared_exponential, singular.noise = 0;
    if (error_rows({{"", "1", [](Vec3) { return 1.0; }, 2 * pi}}, 200, singular)[0].refusal.empty())
        wrong("n = 200, noise 0: NotPositiveDefinite, which the process throws, should go on to error_rows");
}

// ---- shade

void cosine_rule_is_right() {
    for (const std::size_t n : sizes) {
        const QuadratureRule rule{directions_of(n), Numbers(n, 0.1 + 1 / real(n)), Known::nothing};
        const QuadratureRule came = cosine_rule(rule);
        const std::string in = formatted("n = %zu: ", n);
        expect_size(in, "directions", came.directions.size(), n);
        expect_size(in, "weights", came.weights.size(), n);
        for (std::size_t i = 0; i < n; ++i) {
            const double cosine = rule.directions[i].y;
            const std::string what =
                in + formatted("the weight of cos(theta) = %.4g, which was %.4g,", cosine, rule.weights[i]);
            expect(what, came.weights[i], rule.weights[i] * cosine, real(n), 1e-6,
                   {{rule.weights[i], "cos(theta) is missing"},
                    {rule.weights[i] * cosine * cosine, "cos(theta) is there twice"}});
            expect_direction(in + formatted("direction %zu", i), came.directions[i], rule.directions[i]);
        }
        if (came.known != Known::cosine) wrong(in + "its known part is nothing, right is cosine");
        if (cosine_rule(came).weights != came.weights) wrong(in + "cos(theta) goes into a rule that has it already");
    }
}

void reflected_light_is_right() {
    Random random(seed, 6);
    EnvironmentMap map(16, 8);
    for (int texel = 0; texel < 16 * 8; ++texel) {
        const double red = random.uniform(), green = random.uniform();
        map.set(texel % 16, texel / 16, {0.1 + red, 0.1 + green, 0.1 + red * green});
    }
    const Scene scene = sphere_scene();
    for_each_hit(scene, {24, 24}, [&](int x, int y, const Hit& hit) {
        if ((x + y) % 3 != 0) return;
        Frame frame(hit.normal);
        if (y % 2 == 0) frame.tangent = -1 * frame.tangent, frame.bitangent = -1 * frame.bitangent;  // half a turn
        QuadratureRule rule{directions_of(x % 2 == 0 ? 9 : 41), {}, Known::cosine};
        Color right, open;
        for (const Vec3& w : rule.directions) {
            rule.weights.push_back(random.uniform() - 0.2);
            const Color light = rule.weights.back() / pi * (hit.albedo * map.radiance(frame.to_world(w)));
            open += light;
            if (!is_shadowed(scene, hit, frame.to_world(w))) right += light;
        }
        const Color came = reflected_radiance(scene, map, hit, rule, frame);
        const std::string in = std::string("at a point of the ") +
                               (hit.object == Object::sphere ? "sphere" : "rectangle") + " with the normal " +
                               text(hit.normal) + ": ";
        const auto channel = [&](const char* name, double c, double r, double o) {
            expect(in + name, c, r, real(rule.size()), 1e-5,
                   {{o, "there is light from directions in the shadow"}, {pi * r, "1 / pi is missing"}});
        };
        channel("red", came.x, right.x, open.x);
        channel("green", came.y, right.y, open.y);
        channel("blue", came.z, right.z, open.z);
    });
}

// ---- rotate

// By the azimuth, which is 0 at +z.
Vec3 turned(Vec3 v, double angle) {
    const double azimuth = std::atan2(v.x, v.z) + angle, across = std::hypot(v.x, v.z);
    return {across * std::sin(azimuth), v.y, across * std::cos(azimuth)};
}

void rotate_around_y_is_right() {
    for (const Vec3& v : directions_of(41))
        for (const double turns : {0.25, 0.1, -0.7, 3.4})
            expect_direction(text(v) + formatted(" turned by %g", turns), rotate_around_y(v, turns),
                             turned(v, 2 * pi * turns),
                             {{turned(v, turns), "turns are taken for radians"},
                              {turned(v, -2 * pi * turns), "it turns from x towards z"}});
}

void rotated_is_right() {
    const Directions normals = directions_of(41), local = directions_of(3);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const double turns = real(i + 1) / 17;
        const Frame straight(i % 2 == 0 ? normals[i] : -1 * normals[i]);
        const Frame frame = i < 20 ? straight : straight.rotated(0.3),
                    came = frame.rotated(turns);  // turned once, twice
        const std::string in = "the normal " + text(frame.normal) + formatted(", turned by %.3g: ", turns);
        expect_direction(in + "the frame's normal", came.normal, frame.normal);
        for (const Vec3& v : local)
            expect_direction(in + "to_world of " + text(v), came.to_world(v), frame.to_world(turned(v, 2 * pi * turns)),
                             {{frame.to_world(turned(v, turns)), "turns are taken for radians"},
                              {frame.to_world(turned(v, -2 * pi * turns)), "it turns from x towards z"}});
    }
}

// ---- shared_rules and rule_for

RenderSettings settings_of(Method method, std::size_t samples) {
    RenderSettings settings;
    settings.method = method, settings.samples = samples, settings.pool = 7, settings.noise = 0.05,
    settings.seed = seed;
    if (samples == 41) settings.placement = Placement::cosine;
    if (method == Method::mc) settings.placement = Placement::fibonacci;
    return settings;
}

QuadratureRule fresh_right_rule(const RenderSettings& settings, Random& random) {
    const DirectionSet set = place_directions(settings.placement, settings.samples, random);
    if (settings.method == Method::mc) return monte_carlo_rule(set);
    return bayesian_rule(*settings.make_covariance(), settings.noise, set.directions);
}

void expect_rule(const std::string& in, const QuadratureRule& came, const Frame& its, const QuadratureRule& right,
                 const Frame& frame) {
    expect_size(in, "directions", came.directions.size(), right.directions.size());
    expect_size(in, "weights", came.weights.size(), right.weights.size());
    for (std::size_t j = 0; j < right.size(); ++j) {
        expect(in + formatted("weight %zu", j), came.weights[j], right.weights[j], real(right.size()), 1e-6,
               {{right.weights[j] / right.directions[j].y, "cos(theta) is missing"}});
        expect_direction(in + formatted("in the world, direction %zu", j), its.to_world(came.directions[j]),
                         frame.to_world(right.directions[j]));
    }
}

void shared_rules_is_right() {
    for (const Method method : {Method::single, Method::rotated, Method::pool, Method::mc})
        for (const std::size_t n : {3u, 41u}) {
            const RenderSettings settings = settings_of(method, n);
            const PixelRules rules(settings);
            const std::string in = formatted("method %s%s, n = %zu: ", method_names[static_cast<int>(method)].first,
                                             method == Method::mc ? " on a lattice" : "", n);
            expect_size(in, "rules", rules.shared().size(), method == Method::pool ? 7 : 1);
            for (std::size_t i = 0; i < rules.shared().size(); ++i) {
                Random random(seed, (std::uint64_t{1} << 63) + i);
                const QuadratureRule right = fresh_right_rule(settings, random);
                const Frame frame({0, 1, 0});
                expect_rule(in + formatted("rule %zu, of rule_stream(settings_, %zu): ", i, i), *rules.shared()[i],
                            frame, cosine_rule(right), frame);
            }
        }
}

template <Method method>
void rule_for_is_right() {
    for (const std::size_t n : {3u, 41u}) {
        const RenderSettings settings = settings_of(method, n);
        const PixelRules rules(settings);
        for (const Vec3& direction : directions_of(41)) {
            const Vec3 normal = direction.x < 0 ? direction : -1 * direction;
            const std::uint64_t pixel = static_cast<std::uint64_t>(1e6 * direction.y);
            Random random(seed, pixel), copy(seed, pixel);
            const std::string in = "the normal " + text(normal) + formatted(", n = %zu: ", n);
            const OrientedRule came = rules.rule_for(normal, random);
            if (!came.rule) {
                wrong(in + "there is no rule");
                continue;
            }
            if (method == Method::direct) {
                expect_rule(in, *came.rule, came.frame, cosine_rule(fresh_right_rule(settings, copy)), Frame(normal));
                continue;
            }
            const double u = method == Method::pool ? copy.uniform() : 0;
            const std::size_t chosen = static_cast<std::size_t>(u * real(rules.shared().size()));
            for (std::size_t i = 0; i < rules.shared().size(); ++i)
                if (i != chosen && came.rule->weights == rules.shared()[i]->weights)
                    wrong(in + formatted("the first random number, %.4g, chooses rule %zu of the rules 0 to 6, and the "
                                         "second one turns it: it is rule %zu",
                                         u, chosen, i));
            const double turns = method == Method::single ? 0 : copy.uniform();
            expect_rule(in + formatted("turned by %.3g: ", turns), *came.rule, came.frame, *rules.shared()[chosen],
                        Frame(normal).rotated(turns));
        }
    }
}

// The functions of each task.
const std::map<std::string, std::vector<std::pair<const char*, void (*)()>>> tasks{
    {"montecarlo", {{"monte_carlo_rule", monte_carlo_rule_is_right}}},
    {"inverse",
     {{"covariance_matrix", covariance_matrix_is_right},
      {"covariance_matrix", equal_directions_have_equal_rows},
      {"upper_factor", upper_factor_is_right},
      {"inverse", inverse_is_right}}},
    {"z", {{"z_of", z_of_is_right}}},
    {"integral",
     {{"bayesian_weights", bayesian_weights_is_right},
      {"posterior_variance", posterior_variance_is_right},
      {"integral", integral_is_right}}},
    {"table", {{"add_mc_errors", add_mc_errors_is_right}, {"add_bmc_errors", add_bmc_errors_is_right}}},
    {"shade", {{"cosine_rule", cosine_rule_is_right}, {"reflected_radiance", reflected_light_is_right}}},
    {"rotate", {{"rotate_around_y", rotate_around_y_is_right}, {"rotated", rotated_is_right}}},
    {"shared_rules", {{"shared_rules", shared_rules_is_right}}},
    {"rule_for",
     {{"rule_for direct", rule_for_is_right<Method::direct>},
      {"rule_for single", rule_for_is_right<Method::single>},
      {"rule_for rotated", rule_for_is_right<Method::rotated>},
      {"rule_for pool", rule_for_is_right<Method::pool>}}}};

#if __has_include(<execinfo.h>)
// For the check, the addresses from which a line of the source follows.
void crash(int signal) {
    const std::string line =
        "wrong: " + function +
        (signal == SIGALRM   ? ": it does not end: an endless loop?"
         : signal == SIGSEGV ? ": it crashes: an endless recursion, or an address where nothing is?"
                             : ": it crashes");
    std::cout << line << std::endl;
    void* addresses[60];
    backtrace_symbols_fd(addresses, backtrace(addresses, 60), STDERR_FILENO);
    std::_Exit(1);
}

void catch_crashes() {
    static char memory[1 << 16];  // where the stack has overflown
    const stack_t stack{memory, 0, sizeof memory};
    sigaltstack(&stack, nullptr);
    struct sigaction action = {};
    action.sa_handler = crash;
    action.sa_flags = SA_ONSTACK;
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGALRM, SIGBUS, SIGILL}) sigaction(signal, &action, nullptr);
    alarm(8);
}
#else
void catch_crashes() {}
#endif

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3 || tasks.count(argv[1]) == 0) return 2;
    seed = std::strtoull(argv[2], nullptr, 10);
    catch_crashes();
    for (const auto& [name, is_right] : tasks.at(argv[1])) {
        function = name;
        try {
            is_right();
            continue;
        } catch (const Wrong&) {
        } catch (const std::bad_alloc&) {
            std::cout << "wrong: " << name << ": no memory is left: does a loop go on for ever?" << std::endl;
        } catch (const std::exception& error) {
            std::cout << "wrong: " << name << ": it throws: " << error.what() << std::endl;
        }
        wrong_functions.insert(name);
    }
    if (argc > 3) std::cout << values;
    return wrong_functions.empty() ? 0 : 1;
}
