// check_tasks FUNCTION SEED calls a function of a task on inputs that follow from the seed, and prints a line for each
// number that it gives: words for the input and the number, and the number. build/compare compares these lines with
// those of the solution. For that the inputs are well conditioned: with noise of 3.1 any right program agrees in eight
// digits, and one with floats does not. What other functions of its file make is replaced: a mistake costs one task.
#include "base/formatted.h"
#include "experiments/error_table.h"
#include "quadrature/gaussian_process.h"
#include "scene/render.h"

#include <unistd.h>
#include <iostream>
#include <map>

using namespace bmc;
using Directions = std::vector<Vec3>;
using Numbers = std::vector<double>;

namespace {
std::uint64_t seed = 1;
std::FILE* lines;  // where they go; standard output is for what a task should not print
std::string in;    // the input that is tried
long excused = 0;  // bytes on standard output that another function has printed

// ---- What is printed

long printed() {
    std::cout.flush(), std::fflush(stdout);
    return static_cast<long>(lseek(1, 0, SEEK_END));
}
void value(const std::string& what, const std::string& is) {
    std::fprintf(lines, "%s%s %s\n", in.c_str(), what.c_str(), is.c_str());
    std::fflush(lines);
}
void value(const std::string& what, double number) { value(what, formatted("%.12g", number)); }
void vector(const std::string& what, Vec3 v) {
    value(what + ".x", v.x), value(what + ".y", v.y), value(what + ".z", v.z);
}
void numbers(const std::string& what, const Numbers& of) {
    value(what + ".size()", static_cast<double>(of.size()));
    for (std::size_t i = 0; i < of.size(); ++i) value(what + formatted("[%zu]", i), of[i]);
}
void matrix(const std::string& what, const Matrix& m) {
    value(what + ".elements.size()", static_cast<double>(m.elements.size()));
    for (std::size_t i = 0; i < m.rows; ++i)
        for (std::size_t j = 0; j < m.columns; ++j) value(what + formatted("(%zu, %zu)", i, j), m(i, j));
}

// Where the frame carries the directions, if there is one: it does not matter whether it or the rule was rotated.
void rule(const QuadratureRule& of, const Frame* frame = nullptr) {
    numbers("weights", of.weights);
    value("directions.size()", static_cast<double>(of.directions.size()));
    for (std::size_t i = 0; i < of.directions.size(); ++i)
        vector(formatted(frame ? "to_world(directions[%zu])" : "directions[%zu]", i),
               frame ? frame->to_world(of.directions[i]) : of.directions[i]);
    value("known", name_of(of.known, known_names));
}

// ---- Inputs

constexpr std::size_t sizes[] = {3, 1, 9, 40};

Directions directions_of(std::size_t n) {
    Random random(seed, n);
    return random_directions(n, random);
}
Numbers numbers_of(std::size_t n, std::uint64_t stream) {
    Random random(seed, stream);
    Numbers of(n);
    for (double& each : of) each = 0.5 + 3 * random.uniform();
    return of;
}

// Calls f(settings, covariance, directions). What is known and where samples are placed are different things.
template <class Function>
void each_model(Function f) {
    const char* const words[] = {"Sobolev 1.5", "squared exponential 0.4", "known part cosine", "placement cosine"};
    for (const std::size_t n : sizes)
        for (std::size_t i = 0; i < std::size(words); ++i) {
            ErrorSettings model;
            model.noise = 3.1, model.length_scale = 0.4, model.seed = seed, model.known = Known(i == 2);
            if (i == 1) model.covariance = CovarianceFamily::squared_exponential;
            if (i == 3) model.placement.density = Density::cosine;
            in = formatted("%s, noise 3.1, n = %zu: ", words[i], n);
            f(model, *model.make_covariance(), directions_of(n));
        }
}

// Calls f(b b^T + 1), whose eigenvalues are at least 1.
template <class Function>
void each_positive_matrix(Function f) {
    for (const std::size_t n : sizes) {
        const Numbers b = numbers_of(n, 1000 + n);
        Matrix a(n, n);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) a(i, j) = (b[i] - 2) * (b[j] - 2) + (i == j ? 1 : 0);
        in = formatted("n = %zu: ", n);
        f(a);
    }
}

// Calls f(the rules of a picture). Fixed placements need the task rotate.
template <class Function>
void each_picture(Method method, Function f) {
    for (const Placement placement :
         {Placement{}, Placement{PointSet::random, Density::cosine}, Placement{PointSet::stratified}}) {
        RenderSettings settings;
        settings.noise = 3.1, settings.seed = seed, settings.samples = 9, settings.pool = 7;
        settings.method = method, settings.placement = placement;
        in = method_names[static_cast<int>(method)] + (", " + placement.name() + ": ");
        f(PixelRules(settings));
    }
}

void error_rows_of(std::size_t mc_estimates, std::size_t bmc_estimates) {
    const std::vector<Integrand> all = {{"cos^2", [](Vec3 w) { return w.y * w.y; }, 2 * portable::pi / 3},
                                        {"1 + x", [](Vec3 w) { return 1 + w.x; }, 2 * portable::pi}};
    each_model([&](ErrorSettings model, const Covariance&, const Directions& w) {
        model.mc_estimates = mc_estimates, model.bmc_estimates = bmc_estimates;
        const std::vector<ErrorRow> rows = error_rows(all, w.size(), model);
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (const auto& [name, of] : std::map<std::string, Statistics>{
                     {", mc", rows[i].mc}, {", bmc", rows[i].bmc}, {", predicted", rows[i].predicted}})
                value(all[i].formula + name + ".count", of.count), value(all[i].formula + name + ".mean", of.mean);
    });
}

// ---- What is called for each function in the table of tests/course/tasks

std::map<std::string, std::function<void()>> all_checks() {
    std::map<std::string, std::function<void()>> check;
    check["covariance_matrix"] = [] {
        each_model([](const ErrorSettings& model, const Covariance& k, const Directions& w) {
            matrix("Q", covariance_matrix(k, model.noise, w));
        });
    };
    check["upper_factor"] = [] {
        each_positive_matrix([](const Matrix& a) { matrix("U", Cholesky(a).upper); });
        Matrix a(2, 2);
        a.elements = {1, 1, 1, 1 + DBL_EPSILON}, in = "with a second pivot of 2e-16, a rounding error: ";
        try {
            value("U(1, 1)", Cholesky(a).upper(1, 1));
        } catch (const NotPositiveDefinite&) {
            value("U(1, 1)", "NotPositiveDefinite");
        }
    };
    check["inverse"] = [] { each_positive_matrix([](const Matrix& a) { matrix("inverse", Cholesky(a).inverse()); }); };
    check["z_of"] = [] {
        each_model([](const ErrorSettings&, const Covariance& k, Directions w) {
            w.insert(w.end(), {{0, 1 + 4e-16, 0}, {1, 0, 0}, {0, 1, 0}});
            numbers("z", z_of(k, w));
        });
    };
    check["bayesian_weights"] = [] {
        each_positive_matrix(
            [](const Matrix& a) { numbers("weights", bayesian_weights(Cholesky(a), numbers_of(a.rows, 7))); });
    };
    check["posterior_variance"] = [] {
        for (const std::size_t n : sizes)
            for (const double zz : {1e-3, 1e3, 1e4}) {  // less than z^T w, and more
                in = formatted("n = %zu, zz = %g: ", n, zz);
                value("variance", posterior_variance(zz, numbers_of(n, 7), numbers_of(n, 8)));
            }
    };
    check["integral"] = [] {
        GaussianProcess process(Sobolev(), 3.1, {{0.6, 0.8, 0}});
        excused = printed();
        each_positive_matrix([&](const Matrix& a) {
            process.directions = directions_of(a.rows), process.z = numbers_of(a.rows, 7);
            process.cholesky = Cholesky(a), process.weights = process.cholesky.solve(process.z);
            value("estimate", process.integral(numbers_of(a.rows, 9)));
        });
    };
    check["monte_carlo_rule"] = [] {
        for (const Density density : {Density::uniform, Density::cosine})
            for (const std::size_t n : sizes) {
                in = formatted("n = %zu, p = %s: ", n, density == Density::cosine ? "cos(theta)" : "1");
                rule(monte_carlo_rule(directions_of(n), density));
            }
    };
    check["add_mc_errors"] = [] { error_rows_of(7, 0); };
    check["add_bmc_errors"] = [] { error_rows_of(0, 5); };
    check["cosine_rule"] = [] {
        for (const Known known : {Known::nothing, Known::cosine}) {
            in = formatted("known part %s: ", name_of(known, known_names));
            rule(cosine_rule({directions_of(9), numbers_of(9, 7), known}));
        }
    };
    check["reflected_radiance"] = [] {  // by rays that do not depend on the seed; none passes an edge within 0.0015
        EnvironmentMap map(16, 8);
        const Numbers light = numbers_of(16 * 8 * 3, 6);
        for (std::size_t i = 0; i < 16 * 8; ++i)
            map.set(static_cast<int>(i % 16), static_cast<int>(i / 16), {light[i], light[128 + i], light[256 + i]});
        for_each_hit({24, 24}, [&](int x, int y, const Hit& hit) {
            if ((x + y) % 5 != 0) return;
            const std::size_t n = x % 2 == 0 ? 9 : 40;
            QuadratureRule of{fibonacci_directions(n), numbers_of(n, 7), Known::cosine};
            of.weights[2] = -0.2;
            Frame frame(hit.normal);
            if (y % 2 == 0) frame.tangent = -1 * frame.tangent, frame.bitangent = -1 * frame.bitangent;  // half a turn
            in = formatted("column %d, row %d of 24: ", x, y);
            vector("colour", reflected_radiance(sphere_scene, map, hit, of, frame));
        });
    };
    check["shared_rules"] = [] {
        for (const Method method : {Method::single, Method::rotated, Method::pool})
            each_picture(method, [](const PixelRules& rules) {
                const std::string picture = in;
                value("rules.size()", static_cast<double>(rules.shared.size()));
                for (std::size_t i = 0; i < rules.shared.size(); ++i) {
                    in = picture + formatted("rule %zu, ", i);
                    rule(*rules.shared[i]);
                }
            });
    };
    check["rotate_around_y"] = [] {
        for (const Vec3& v : directions_of(9)) {  // by 0.1 turns in all, for which a pi of nine digits will do
            in = formatted("(%.4g, %.4g, %.4g): ", v.x, v.y, v.z);
            vector("rotated by 0.1 turns", rotate_around_y(v, 0.1));
            vector("rotated by 3.4 and -3.3 turns", rotate_around_y(rotate_around_y(v, 3.4), -3.3));
        }
    };
    check["rotated"] = [] {
        for (const Vec3& normal : directions_of(9)) {
            const Frame frame = Frame(normal).rotated(0.7).rotated(-0.6);
            in = formatted("normal (%.4g, %.4g, %.4g), 0.7 and -0.6 turns: ", normal.x, normal.y, normal.z);
            vector("normal", frame.normal), vector("tangent", frame.tangent), vector("bitangent", frame.bitangent);
        }
    };
    for (const Method method : {Method::direct, Method::single, Method::rotated, Method::pool})
        check[std::string("rule_for_") + method_names[static_cast<int>(method)]] = [=] {
            each_picture(method, [](const PixelRules& rules) {
                const std::string picture = in;
                excused = printed();
                for (std::size_t i = 0; i < rules.shared.size(); ++i)
                    const_cast<QuadratureRule&>(*rules.shared[i]) = {directions_of(9), numbers_of(9, i), Known::cosine};
                for (const Vec3& normal : directions_of(12)) {
                    Random random(seed, static_cast<std::uint64_t>(1e6 * normal.y));
                    const OrientedRule came = rules.rule_for(normal, random);
                    in = picture + formatted("normal (%.4g, %.4g, %.4g), ", normal.x, normal.y, normal.z);
                    rule(*came.rule, &came.frame);
                }
            });
        };
    return check;
}
}  // namespace

int main(int argc, char** argv) {
    const auto checks = all_checks();
    std::FILE* const out = std::tmpfile();
    lines = fdopen(dup(1), "w");
    if (argc != 3 || checks.count(argv[1]) == 0 || !out || dup2(fileno(out), 1) < 0) return 2;
    seed = std::strtoull(argv[2], nullptr, 10);
    try {
        checks.at(argv[1])();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 3;
    }
    std::fprintf(lines, "number of bytes on std::cout (use std::cerr) %ld\n", printed() - excused);
    return 0;
}
