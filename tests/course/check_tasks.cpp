// check_tasks FUNCTION SEED calls a function of a task on inputs that follow from the seed, and prints a line for each
// number that it gives: the input and what the number is, the number, the difference that is allowed, the number of
// samples, and what the number would be after a common mistake, with the mistake. What is right is not known here: the
// lines of a student's program are compared, by build/verdict, with those of the solution's. So only the solution's
// differences and mistakes count, and a mistake may be stated by the solution's own number.
#include "experiments/error_table.h"
#include "scene/render.h"

#include <array>
#include <functional>
#include <iostream>
#include <map>
#include <numeric>

#include <unistd.h>

using namespace bmc;
using portable::pi;
using Directions = std::vector<Vec3>;
using Numbers = std::vector<double>;

namespace {

std::uint64_t seed = 1;
std::FILE* values;   // where the lines go; standard output is for what a task should not print
std::string in;      // the input that is tried
double samples = 1;  // how many it has

std::map<std::string, void (*)()> checks;  // of each function

struct Check {
    Check(const char* function, void (*check)()) { checks[function] = check; }
};

template <class Number>
struct Mistake {
    Number gives;
    const char* words;
};
using Mistakes = std::vector<Mistake<double>>;

// Numbers of one array are about as large as its scale, by which rounding errors are measured.
void value(const std::string& what, double number, double tolerance, double scale = 0, const Mistakes& mistakes = {}) {
    const double allowed = tolerance * std::max(std::fabs(number), scale) + 1e-12;
    std::fprintf(values, "%s%s\t%.12g\t%.3g\t%.12g", in.c_str(), what.c_str(), number, allowed, samples);
    for (const Mistake<double>& each : mistakes) std::fprintf(values, "\t%.12g\t%s", each.gives, each.words);
    std::fputc('\n', values);
    std::fflush(values);
}

void count(const std::string& things, std::size_t number) {
    value("the number of " + things, static_cast<double>(number), 0);
}

// 1 if f throws such an exception, 0 if not.
template <class Exception, class Function>
void throws(const std::string& what, const char* hint, Function f) {
    double thrown = 0;
    try {
        f();
    } catch (const Exception&) {
        thrown = 1;
    }
    value("the number of exceptions for " + what, thrown, 0, 0, {{0, hint}});
}

std::string text(Vec3 v) { return formatted("(%.4g, %.4g, %.4g)", v.x, v.y, v.z); }

void vector(const std::string& what, Vec3 v, const std::vector<Mistake<Vec3>>& mistakes = {},
            const std::array<const char*, 3>& names = {", x", ", y", ", z"}) {
    for (std::size_t i = 0; i < 3; ++i) {
        double Vec3::*const part = i == 0 ? &Vec3::x : i == 1 ? &Vec3::y : &Vec3::z;
        Mistakes of_part;
        for (const Mistake<Vec3>& each : mistakes) of_part.push_back({each.gives.*part, each.words});
        value(what + names[i], v.*part, 1e-9, 1, of_part);
    }
}

// mistakes(i) are those of a number.
void numbers(const std::string& what, const Numbers& of, double tolerance,
             const std::function<Mistakes(std::size_t)>& mistakes = {}) {
    double scale = 0;
    for (const double each : of) scale = std::max(scale, std::fabs(each));
    for (std::size_t i = 0; i < of.size(); ++i)
        value(what + formatted(" %zu", i), of[i], tolerance, scale, mistakes ? mistakes(i) : Mistakes{});
}

// Of large ones, so that files stay small: the first and the last row, the diagonal, and a sum that every one changes.
// mistakes(i, j) are those of an element.
void matrix(const std::string& name, const Matrix& m, double tolerance, double on_diagonal,
            const std::function<Mistakes(std::size_t, std::size_t)>& mistakes = {}) {
    double scale = 0, sum = 0;
    count("elements of " + name, m.rows * m.columns);
    for (const double each : m.elements) scale = std::max(scale, std::fabs(each));
    for (std::size_t i = 0; i < m.rows; ++i)
        for (std::size_t j = 0; j < m.columns; ++j) {
            sum += static_cast<double>(1 + (i + 2 * j) % 7) * m(i, j);
            if (m.rows < 10 || i == 0 || i + 1 == m.rows || i == j)
                value(name + formatted("(%zu, %zu)", i, j), m(i, j), i == j ? on_diagonal : tolerance, scale,
                      mistakes ? mistakes(i, j) : Mistakes{});
        }
    value("the sum of (1 + (i + 2 j) % 7) times the elements of " + name, sum, on_diagonal,
          scale * static_cast<double>(m.elements.size()));
}

Directions directions_of(std::size_t n) {
    Random random(seed, n);
    return random_directions(n, random);
}

// What the same Q but for rounding may change. The squared chord of a direction and itself is 0, or 2 - 2 w.w, where
// each square of a coordinate has some six roundings of 1.1e-16 (in sin(theta), the azimuth, and their product), and
// w.w four more: at most 2 * 14 roundings, 3.1e-15. It changes the diagonal by this part. The squared exponential
// changes so little that a float shows, whose rounding is 6e-8.
double rounding(const Covariance& k) { return std::max(1e-11, 1 - k.k(4e-15) / k.k(0)); }

// Such a change of Q changes the weights by at most the largest sum of absolute values in a row of Q^-1 as much, and
// that is at most about 1 / noise^2.
double tolerance_of(const Covariance& k, double noise) { return 1e-9 + rounding(k) * k.k(0) / (noise * noise); }

// Calls f(model, its covariance, its directions) for each of the models, without lattices, which the task rotate turns.
template <class Function>
void for_each_model(Function f) {
    constexpr CovarianceFamily sobolev = CovarianceFamily::sobolev, smooth = CovarianceFamily::squared_exponential;
    const struct {
        const char* words;
        std::size_t n;
        double noise;
        CovarianceFamily family = sobolev;
        KnownPart known_part = KnownPart::nothing;
        Placement placement = Placement::uniform;
        double smoothness = 1.5;
    } models[] = {{"Sobolev 1.5", 3, 0.3},
                  {"Sobolev 1.5", 1, 0.3},
                  {"squared exponential 0.4", 3, 0.3, smooth},
                  {"Sobolev 1.4", 9, 0.05, sobolev, KnownPart::nothing, Placement::cosine, 1.4},
                  {"Sobolev 1.5 with the known part cosine", 8, 0.05, sobolev, KnownPart::cosine},
                  {"Sobolev 1.5", 100, 0.01}};  // no program takes more unless it is asked to
    for (const auto& each : models) {
        ErrorSettings model;
        model.noise = each.noise, model.covariance = each.family, model.known_part = each.known_part, model.seed = seed;
        model.placement = each.placement, model.smoothness = each.smoothness, model.length_scale = 0.4;
        in = formatted("%s, noise %g, n = %zu: ", each.words, each.noise, each.n);
        samples = static_cast<double>(each.n);
        f(model, *model.make_covariance(), directions_of(each.n));
    }
}

// ---- inverse

const Check covariance_matrix_check("covariance_matrix", [] {
    for_each_model([](const ErrorSettings& model, const Covariance& k, const Directions& w) {
        const double k0 = k.k(0), square = model.noise * model.noise;
        matrix("Q", covariance_matrix(k, model.noise, w), 1e-11, rounding(k), [&](std::size_t i, std::size_t j) {
            const double chord = length(w[i] - w[j]);
            if (i == j)
                return Mistakes{{k0 + model.noise, "the noise is added, and its square should be"},
                                {k0, "noise^2 is missing"}};
            return Mistakes{{k.k(chord), "that is k(chord), and k takes the squared chord"},
                            {k.k(chord * chord) + square, "noise^2 is for the diagonal alone"}};
        });
    });
    in = "noise 0.3, the direction (0, 1, 0) twice: ", samples = 2;
    matrix("Q", covariance_matrix(Sobolev(), 0.3, {{0, 1, 0}, {0, 1, 0}}), 1e-12, 1e-12,
           [](std::size_t i, std::size_t j) {
               const double all = Sobolev().k(0) + 0.3 * 0.3;
               return Mistakes{{i == j ? NAN : all, "noise^2 is for i = j, not for equal directions"}};
           });
});

// Calls f(A, tolerance) for symmetric matrices with no eigenvalue below the least: if that is small, few digits of a
// float are left in the end; if it is 1, all digits should be right. The tolerance is a rounding, magnified by A.
template <class Function>
void for_each_positive_matrix(Function f) {
    for (const std::size_t n : {3u, 1u, 9u, 41u, 100u})
        for (const double least : {1.0, 1e-4}) {
            Random random(seed, 1000 + n);
            Matrix b(n, n), a(n, n);
            for (double& each : b.elements) each = random.uniform();
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < n; ++j) {
                    a(i, j) = i == j ? least : 0;
                    for (std::size_t l = 0; l < n; ++l) a(i, j) += b(i, l) * b(j, l);
                }
            in = formatted("a matrix with no eigenvalue below %g, n = %zu: ", least, n);
            samples = static_cast<double>(n);
            f(a, 1e-12 + 1e-12 / least);
        }
}

const Check upper_factor_check("upper_factor", [] {
    for_each_positive_matrix(
        [](const Matrix& a, double tolerance) { matrix("U", Cholesky(a).upper, tolerance, tolerance); });
    in = "";
    for (const double last : {0.5, 1 + 2 * DBL_EPSILON}) {  // a pivot below 0, and one of two roundings
        Matrix a(2, 2);
        a(0, 0) = 4, a(0, 1) = a(1, 0) = 2, a(1, 1) = last;
        throws<NotPositiveDefinite>(formatted("the rows (4, 2), (2, 1%+.2g)", last - 1),
                                    "root_of_pivot throws NotPositiveDefinite for such a pivot", [&] { Cholesky{a}; });
    }
});

const Check inverse_check("inverse", [] {
    for_each_positive_matrix(
        [](const Matrix& a, double tolerance) { matrix("the inverse", Cholesky(a).inverse(), tolerance, tolerance); });
});

// ---- z

const Check z_of_check("z_of", [] {
    for_each_model([](const ErrorSettings&, const Covariance& k, Directions w) {
        w.insert(w.end(), {{0, 1 + 4e-16, 0}, {1, 0, 0}, {0, 1, 0}});
        const Numbers z = z_of(k, w);
        samples = static_cast<double>(w.size());
        count("z", z.size());
        for (std::size_t i = 0; i < z.size() && i < w.size(); ++i) {
            const double cosine = std::min(1.0, w[i].y), angle = std::acos(cosine);
            value(formatted("z of direction %zu, ", i) + text(w[i]), z[i], 1e-9, 0,
                  {{angle <= 1 ? k.z(angle) : NAN, "that is z(angle), and z takes the cosine, y"},
                   {k.z(std::min(1.0, std::fabs(w[i].z))), "that is z of z, not of y"},
                   {k.k(cosine), "that is k(y), not z(y)"}});
        }
    });
    in = "";
    throws<std::invalid_argument>("a direction below the horizon", "Covariance::z throws for its y", [] {
        z_of(Sobolev(), {{0.6, -0.8, 0}});
    });
});

// ---- integral

Numbers numbers_of(std::size_t n, std::uint64_t stream) {
    Random random(seed, stream);
    Numbers of(n);
    for (double& each : of) each = 0.5 + 3 * random.uniform();
    return of;
}

const Check bayesian_weights_check("bayesian_weights", [] {
    for_each_positive_matrix([](const Matrix& a, double tolerance) {
        const Cholesky cholesky(a);
        const Numbers z = numbers_of(a.rows, 7), half = cholesky.forward_substitution(z),
                      weights = bayesian_weights(cholesky, z);
        count("weights", weights.size());
        numbers("weight", weights, tolerance, [&](std::size_t i) {
            if (z.size() == 1 || i >= z.size()) return Mistakes{};
            return Mistakes{{half[i], "that is half a solution: of L y = z and U w = y only y"},
                            {z[i], "that is z: Q^-1 is missing"}};
        });
    });
});

const Check posterior_variance_check("posterior_variance", [] {
    for (const std::size_t n : {3u, 1u, 9u, 41u, 100u}) {
        const Numbers z = numbers_of(n, 7), weights = numbers_of(n, 8);
        const double product = std::inner_product(z.begin(), z.end(), weights.begin(), 0.0);
        for (const double more : {0.03, 1.0, -0.1}) {  // the last as by rounding
            const double zz = (1 + more) * product;
            in = formatted("n = %zu, zz = %.4g, z^T w = %.4g: ", n, zz, product), samples = static_cast<double>(n);
            value("the variance", posterior_variance(zz, z, weights), 1e-11, zz,
                  {{zz + product, "z^T w is added, and it should be subtracted"},
                   {zz - product, "a negative variance should be 0"},
                   {product - zz, "where the difference is negative, 0 is right"}});
        }
    }
});

const Check integral_check("integral", [] {
    for_each_model([](const ErrorSettings& model, const Covariance& k, const Directions& directions) {
        const GaussianProcess process(k, model.noise, directions);
        const Numbers &z = process.z, y = numbers_of(z.size(), 9);
        const double sum = std::accumulate(y.begin(), y.end(), 0.0),
                     by_z = std::inner_product(y.begin(), y.end(), z.begin(), 0.0);
        value("the estimate", process.integral(y), tolerance_of(k, model.noise), 2 * pi,
              {{2 * pi * sum / samples, "that is Monte Carlo's"}, {by_z, "that is the sum of z_i Y_i"}});
    });
});

// ---- montecarlo

// The frame that leaves directions as they are.
const Frame upright = [] {
    Frame frame({0, 1, 0});
    frame.tangent = {1, 0, 0}, frame.bitangent = {0, 0, 1};
    return frame;
}();

// The weights, and where the frame carries the directions.
void rule_values(const QuadratureRule& rule, const Frame& frame, double tolerance, bool with_cosine = true) {
    count("directions", rule.directions.size());
    count("weights", rule.weights.size());
    numbers("weight", rule.weights, tolerance, [&](std::size_t i) {
        if (!with_cosine || i >= rule.directions.size()) return Mistakes{};
        return Mistakes{{rule.weights[i] / rule.directions[i].y, "cos(theta) is missing"},
                        {rule.weights[i] * rule.directions[i].y, "cos(theta) is there twice"}};
    });
    for (std::size_t i = 0; i < rule.directions.size(); ++i)
        vector(formatted(&frame == &upright ? "direction %zu" : "in the world, direction %zu", i),
               frame.to_world(rule.directions[i]));
    value("whether the known part is cosine (1) or nothing (0)", rule.known_part == KnownPart::cosine, 0);
}

const Check monte_carlo_rule_check("monte_carlo_rule", [] {
    for (const KnownPart density : {KnownPart::nothing, KnownPart::cosine})
        for (const std::size_t n : {3u, 1u, 41u, 100u}) {
            in = formatted(density == KnownPart::nothing ? "n = %zu: " : "n = %zu, density cos(theta) / pi: ", n);
            samples = static_cast<double>(n);
            rule_values(monte_carlo_rule(directions_of(n), density), upright, 1e-9, false);
        }
});

// ---- table

void errors(const std::string& name, const Statistics& of, double tolerance, const Mistakes& mistakes = {}) {
    samples = of.count;
    value("the number of " + name, of.count, 0);
    value("the mean of the " + name, of.mean, tolerance, 1, mistakes);
    value("the standard error of the " + name, of.standard_error(), tolerance, 1);
}

// Of so many estimates of each method, for each model and integrand.
void error_values(std::size_t mc_estimates, std::size_t bmc_estimates) {
    const std::vector<Integrand> integrands = {{"cos(theta)^2", [](Vec3 w) { return w.y * w.y; }, 2 * pi / 3},
                                               {"1 + x", [](Vec3 w) { return 1 + w.x; }, 2 * pi}};
    for_each_model([&](ErrorSettings model, const Covariance& k, const Directions& w) {
        model.mc_estimates = mc_estimates, model.bmc_estimates = bmc_estimates;
        const std::string of = in + "of ";
        std::size_t i = 0;
        for (const ErrorRow& row : error_rows(integrands, w.size(), model)) {
            in = of + integrands[i++].formula + ", ";
            if (mc_estimates > 0) errors("mc errors", row.mc, 1e-9);
            if (bmc_estimates == 0) continue;
            errors("bmc errors", row.bmc, tolerance_of(k, model.noise));
            errors("predicted errors", row.predicted, tolerance_of(k, model.noise),
                   {{std::sqrt(pi / 2) * row.predicted.mean, "that is the standard error: sqrt(2 / pi) is missing"}});
        }
    });
}
const Check mc("add_mc_errors", [] { error_values(7, 0); });
const Check bmc_errors("add_bmc_errors", [] { error_values(0, 5); });

// ---- shade

const Check cosine_rule_check("cosine_rule", [] {
    for (const std::size_t n : {3u, 1u, 41u, 100u}) {
        in = formatted("n = %zu: ", n), samples = static_cast<double>(n);
        const QuadratureRule rule{directions_of(n), Numbers(n, 0.1 + 1 / samples), KnownPart::nothing};
        rule_values(cosine_rule(rule), upright, 1e-9);
        in += "of a rule whose known part is cosine, ";
        numbers("weight", cosine_rule({rule.directions, rule.weights, KnownPart::cosine}).weights, 1e-9);
    }
});

const Check reflected_radiance_check("reflected_radiance", [] {
    Random random(seed, 6);
    EnvironmentMap map(16, 8);
    for (int texel = 0; texel < 16 * 8; ++texel) {
        const double red = random.uniform(), green = random.uniform();
        map.set(texel % 16, texel / 16, {0.1 + red, 0.1 + green, 0.1 + red * green});
    }
    for_each_hit(sphere_scene, {24, 24}, [&](int x, int y, const Hit& hit) {
        if ((x + y) % 5 != 0) return;
        Hit alone = hit;  // from where no object is in the way
        alone.point.y = 1e9;
        Frame frame(hit.normal);
        if (y % 2 == 0) frame.tangent = -1 * frame.tangent, frame.bitangent = -1 * frame.bitangent;  // half a turn
        QuadratureRule rule{directions_of(x % 2 == 0 ? 9 : 100), {}, KnownPart::cosine};
        samples = static_cast<double>(rule.directions.size());
        for (const Vec3& w : rule.directions) rule.weights.push_back((1 + w.x) * random.uniform() - 0.2);
        QuadratureRule twice = rule;
        for (std::size_t i = 0; i < rule.size(); ++i) twice.weights[i] *= rule.directions[i].y;
        const Colour came = reflected_radiance(sphere_scene, map, hit, rule, frame),
                     open = reflected_radiance(sphere_scene, map, alone, rule, frame),
                     still = reflected_radiance(sphere_scene, map, hit, rule, upright),
                     dark = reflected_radiance(sphere_scene, map, hit, twice, frame);
        in = formatted("in column %d of row %d of 24, normal ", x, y) + text(hit.normal) + ": ";
        vector("", came,
               {{open, "there is light from directions in the shadow"},
                {still, "the frame should carry the directions to the world"},
                {dark, "cos(theta) is in the weights already"},
                {Colour{1 / hit.albedo.x, 1 / hit.albedo.y, 1 / hit.albedo.z} * came, "the albedo is missing"},
                {pi * came, "1 / pi is missing"}},
               {"red", "green", "blue"});
    });
});

// ---- rotate

const Check rotate_around_y_check("rotate_around_y", [] {
    for (const Vec3& v : directions_of(9))
        for (const double turns : {0.25, 0.1, -0.7, 3.4})
            vector(text(v) + formatted(" turned by %g turns", turns), rotate_around_y(v, turns),
                   {{rotate_around_y(v, turns / (2 * pi)), "turns are taken for radians"},
                    {rotate_around_y(v, turns / 360), "turns are taken for degrees"},
                    {rotate_around_y(v, -turns), "it turns from x towards z"}});
});

const Check rotated_check("rotated", [] {
    const Directions normals = directions_of(20), local = directions_of(3);
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const double turns = static_cast<double>(i + 1) / 17;
        const Frame straight(i % 2 == 0 ? normals[i] : -1 * normals[i]);
        const Frame frame = i < 10 ? straight : straight.rotated(0.3);  // turned once, twice
        in = "the normal " + text(frame.normal) + formatted(", turned by %.3g turns: ", turns);
        vector("the frame's normal", frame.rotated(turns).normal);
        for (const Vec3& v : local)
            vector("to_world of " + text(v), frame.rotated(turns).to_world(v),
                   {{frame.rotated(turns / (2 * pi)).to_world(v), "turns are taken for radians"},
                    {frame.rotated(-turns).to_world(v), "it turns from x towards z"},
                    {frame.to_world(v), "it is not turned"}});
    }
});

// ---- shared_rules and rule_for

RenderSettings settings_of(Method method, Placement placement, std::size_t n) {
    RenderSettings settings;
    settings.method = method, settings.placement = placement, settings.samples = n, settings.seed = seed;
    settings.noise = 0.05, settings.pool = n == 3 ? 20 : 7;
    if (n == 20) settings.known_part = KnownPart::cosine;
    samples = static_cast<double>(n);
    return settings;
}

// Without fixed sets, which the task rotate turns.
const Check shared_rules_check("shared_rules", [] {
    for (std::size_t method = 0; method < std::size(method_names); ++method)
        for (std::size_t placement = 0; placement < std::size(placement_names); ++placement)
            for (const std::size_t n : {3u, 20u}) {
                if (is_fixed(static_cast<Placement>(placement))) continue;
                const PixelRules rules(settings_of(static_cast<Method>(method), static_cast<Placement>(placement), n));
                const std::string of = formatted("method %s, placement %s, n = %zu: ", method_names[method],
                                                 placement_names[placement], n);
                in = of;
                count("rules", rules.shared.size());
                for (std::size_t i = 0; i < rules.shared.size(); ++i) {
                    in = of + formatted("rule %zu, from rule_stream(settings, %zu): ", i, i);
                    rule_values(*rules.shared[i], upright, 1e-5);
                }
            }
});

// Which of the shared rules it is, by its weights; -1: none of them.
int index_of(const QuadratureRule& rule, const SharedRules& shared) {
    for (std::size_t i = 0; i < shared.size(); ++i)
        if (shared[i]->weights == rule.weights) return static_cast<int>(i);
    return -1;
}

template <Method method>
void rule_for_values() {
    const std::pair<std::size_t, Placement> sets[] = {
        {3, Placement::uniform}, {20, Placement::cosine}, {40, Placement::stratified}};
    for (const auto& [n, placement] : sets) {
        const PixelRules rules(settings_of(method, placement, n));
        for (const Vec3& direction : directions_of(12)) {
            const Vec3 normal = direction.x < 0 ? direction : -1 * direction;
            const std::uint64_t pixel = static_cast<std::uint64_t>(1e6 * direction.y);
            Random random(seed, pixel), copy(seed, pixel);
            const OrientedRule came = rules.rule_for(normal, random);
            in = "the normal " + text(normal) + formatted(", n = %zu: ", n);
            const double first = copy.uniform();
            if (method != Method::direct)
                value(formatted("with the first random number %.4g, the index of the rule", first),
                      index_of(*came.rule, rules.shared), 0, 0, {{-1, "that is none of the shared rules"}});
            rule_values(*came.rule, came.frame, 1e-5);
            if (n == 3) value("the random number that follows", random.uniform(), 1e-12);
        }
    }
}

const Check direct("rule_for_direct", rule_for_values<Method::direct>);
const Check single("rule_for_single", rule_for_values<Method::single>);
const Check rotated_rule("rule_for_rotated", rule_for_values<Method::rotated>);
const Check pool("rule_for_pool", rule_for_values<Method::pool>);
}  // namespace

int main(int argc, char** argv) {
    std::FILE* const printed = std::tmpfile();
    values = fdopen(dup(1), "w");
    if (argc != 3 || checks.count(argv[1]) == 0 || !printed || dup2(fileno(printed), 1) < 0) return 2;
    seed = std::strtoull(argv[2], nullptr, 10);
    alarm(60);
    try {
        checks.at(argv[1])();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
    std::cout.flush();
    std::fflush(stdout);
    in = "";
    value("the number of bytes on std::cout, which is for the programs' output (use std::cerr),",
          static_cast<double>(lseek(1, 0, SEEK_END)), 0);
    return 0;
}
