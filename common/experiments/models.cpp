#include "experiments/reports.h"

#include "base/progress.h"
#include "base/statistics.h"
#include "experiments/integrands.h"
#include "quadrature/gaussian_process.h"
#include "scene/scene.h"

namespace bmc {
constexpr std::size_t points = 100, sets = 20;

// The default first.
static std::vector<ModelSettings> all_models() {
    constexpr auto sobolev = CovarianceFamily::sobolev, squared_exponential = CovarianceFamily::squared_exponential;
    std::vector<ModelSettings> models{{}};
    for (const double s : {1.1, 1.25, 1.4, 1.8}) models.push_back({sobolev, s, 1, 0.01});
    for (const double noise : {0.001, 0.1, 0.3, 1.0}) models.push_back({sobolev, 1.5, 1, noise});
    for (const double noise : {0.01, 0.1})
        for (const double l : {0.25, 0.5, 1.0, 2.0}) models.push_back({squared_exponential, 1.5, l, noise});
    return models;
}

// Of a model on the integrands, and of Monte Carlo, over the sets of directions. The errors at the points of one set
// are not independent, so a set gives one number of each kind.
struct ModelResults {
    RootMeanSquare error, predicted, monte_carlo;
    Statistics evidence;  // per point
};

static ModelResults results_of(const ModelSettings& model, const std::vector<Integrand>& integrands,
                               std::size_t samples) {
    const auto covariance = model.make_covariance();
    const auto directions_of = directions_of_estimates({}, samples);
    ModelResults all;
    for (std::size_t set = 0; set < sets; ++set) {
        const QuadratureRule rule = monte_carlo_rule(directions_of(set));
        const GaussianProcess process(*covariance, model.noise, rule.directions);
        ModelResults means;
        for (const Integrand& integrand : integrands) {
            const std::vector<double> values = unknown_part(integrand.value, process.directions);
            means.error.add(process.integral(values) - integrand.truth);
            means.predicted.add(process.error_bar(values));
            means.monte_carlo.add(estimate(rule, integrand.value) - integrand.truth);
            if (process.amplitude(values) > 0) means.evidence.add(process.log_evidence(values));  // zeros fit all
        }
        all.error.add(means.error.value());
        all.predicted.add(means.predicted.value());
        all.monte_carlo.add(means.monte_carlo.value());
        all.evidence.add(means.evidence.mean);
    }
    return all;
}

// Incident luminance times cos(theta), shadows included, at random points that pixels of the sphere scene show. The
// truth is a dense quadrature.
static std::vector<Integrand> scene_integrands(const std::shared_ptr<const EnvironmentMap>& light) {
    const QuadratureRule dense = monte_carlo_rule(fibonacci_directions(1 << 16));
    Random random(1, 0);
    std::vector<Integrand> integrands;
    while (integrands.size() < points) {
        const int x = static_cast<int>(500 * random.uniform());
        const int y = static_cast<int>(500 * random.uniform());
        const std::optional<Hit> hit = intersect(sphere_scene, Camera{500, 500}.ray(x, y));
        if (!hit) continue;
        const auto value = [light, hit = *hit, frame = Frame(hit->normal)](Vec3 local) {
            const Vec3 omega = frame.to_world(local);
            return is_shadowed(sphere_scene, hit, omega) ? 0 : luminance(light->radiance(omega)) * local.y;
        };
        integrands.push_back({"L v cos(theta)", value, estimate(dense, value)});
    }
    return integrands;
}

std::string models_report(Arguments& arguments) {
    std::string environment = built_in_lights[0];
    std::size_t samples = 40;
    arguments.add("environment", "FILE", environment_help(), environment);
    arguments.add("samples", "N", "directions of each process", samples, 1, 400);
    arguments.take();
    const auto light = std::make_shared<const EnvironmentMap>(load_environment(environment));
    const std::vector<Integrand> integrands = scene_integrands(light);
    std::string text = formatted(
        R"(# Which model does the scene require? Its light times visibility times cos(theta) at %zu points, by %zu
# sets of %zu samples. rmse: the error of the estimate, with its standard error; ratio: predicted over actual
# rmse, 1 is honest; evidence: log evidence per point less that of the first row, larger is better.
# covariance          parameter  noise       rmse         +-  ratio  evidence
)",
        points, sets, samples);
    double evidence_of_default = 0;
    RootMeanSquare mc;
    const std::vector<ModelSettings> models = all_models();
    Progress progress("models", models.size());
    for (const ModelSettings& model : models) {
        const ModelResults v = results_of(model, integrands, samples);
        mc = v.monte_carlo;
        progress.done();
        const double ratio = v.predicted.value() / v.error.value();
        if (evidence_of_default == 0) evidence_of_default = v.evidence.mean;
        text += formatted("%-21s %9g %6g %10.4g %10.2g %6s %9.1f\n", name_of(model.covariance, covariance_names),
                          model.parameter(), model.noise, v.error.value(), v.error.standard_error(),
                          std::isfinite(ratio) ? formatted("%.2f", ratio).c_str() : "nan",
                          v.evidence.mean - evidence_of_default);
    }
    return text + formatted("%-21s %9s %6s %10.4g %10.2g %6s %9s\n", "monte-carlo", "nan", "nan", mc.value(),
                            mc.standard_error(), "nan", "nan");
}
}  // namespace bmc
