#include "experiments/models.h"

#include "experiments/statistics.h"
#include "light/desert.h"
#include "quadrature/gaussian_process.h"
#include "scene/scene.h"

#include <algorithm>
#include <cmath>

namespace bmc {
namespace {

constexpr std::size_t n = 40;
constexpr std::size_t standard_model = 3;  // Sobolev 3/2, noise 0.01

std::vector<std::pair<Model, double>> models_and_noises() {
    std::vector<std::pair<Model, double>> models;
    for (const double s : {1.1, 1.25, 1.4, 1.5, 1.8}) models.push_back({{CovarianceFamily::sobolev, s}, 1e-2});
    for (const double noise : {1e-3, 1e-1}) models.push_back({{CovarianceFamily::sobolev, 1.5}, noise});
    for (const double noise : {1e-2, 1e-1})
        for (const double l : {0.25, 0.5, 1.0, 2.0})
            models.push_back({{CovarianceFamily::squared_exponential, l}, noise});
    return models;
}

// A column of the tables: its integrands, the number of sets of directions, and the verdicts of each model.
struct Column {
    std::string name;
    std::vector<Integrand> integrands;
    std::size_t sets;
    std::vector<Examined> examined;
};

std::vector<Column> all_columns() {
    std::vector<Column> columns{{"cosine", {practice_integrands()[1]}, 1000, {}}};
    for (const char* name : built_in_lights) {
        const auto light = std::make_shared<const EnvironmentMap>(load_environment(name));
        columns.push_back({name, scene_integrands(light, 100), 10, {}});
    }
    for (Column& column : columns)
        for (const auto& [model, noise] : models_and_noises())
            column.examined.push_back(examine(model, noise, column.integrands, n, column.sets));
    return columns;
}

std::string model_table(const std::vector<Column>& columns) {
    std::string text =
        "# Which model? Root mean square errors with 40 samples: of cos(theta), and of incident radiance "
        "times cos(theta)\n# at 100 points of the scene, drawn at random, under each light.\n"
        "# covariance        parameter  noise";
    for (const Column& column : columns) text += formatted(" %15s", column.name.c_str());
    text += '\n';
    for (std::size_t i = 0; i < columns[0].examined.size(); ++i) {
        const auto& [model, noise, verdicts] = columns[0].examined[i];
        text += formatted("%-20s %8g %6g", name_of(model.family, covariance_names), model.parameter, noise);
        for (const Column& column : columns) text += formatted(" %15.4g", column.examined[i].rmse());
        text += '\n';
    }
    text += "monte-carlo                 -      -";
    for (const Column& column : columns)
        text += formatted(" %15.4g", monte_carlo_rmse(column.integrands, n, column.sets));
    return text + '\n';
}

std::string choice_table(const std::vector<Column>& columns) {
    std::string text =
        "\n\n# Which of these models do the samples choose by the evidence, without the truth? The RMSE of Sobolev 3/2 "
        "with\n"
        "# noise 0.01; of the model that one set of 40 values chooses, and how often it is squared-exponential; and of "
        "the\n"
        "# one that all sets choose together.\n"
        "# integrand       sobolev_3/2     chosen  smooth  pooled\n";
    for (const Column& column : columns) {
        const Choice choice = choice_by_evidence(column.examined);
        text += formatted("%-16s %12.4g %10.4g %7.2f %7.4g\n", column.name.c_str(),
                          column.examined[standard_model].rmse(), choice.rmse, choice.smooth, choice.pooled_rmse);
    }
    return text;
}

std::string coverage_table(const std::vector<Column>& columns) {
    std::string text =
        "\n\n# Is the error bar honest? Fraction of errors within two predicted standard errors, and "
        "predicted over actual RMSE.\n# samples";
    for (const Column& column : columns) text += formatted(" %15s %6s", column.name.c_str(), "ratio");
    text += '\n';
    for (const std::size_t count : {2u, 5u, 10u, 20u, 40u, 80u, 160u}) {
        text += formatted("%9zu", count);
        for (const Column& column : columns) {
            const Examined model =
                examine({CovarianceFamily::sobolev, 1.5}, 1e-2, column.integrands, count, column.sets);
            text += formatted(" %15.3f %6.2f", model.coverage(), model.predicted() / model.rmse());
        }
        text += '\n';
    }
    return text;
}

Integrand scene_integrand(const std::shared_ptr<const EnvironmentMap>& light, const Scene& scene, const Hit& hit,
                          const QuadratureRule& dense) {
    const Frame frame(hit.normal);
    Integrand integrand{"scene", "L(w) cos(theta) at a point of the scene", nullptr, 0};
    integrand.value = [=](Vec3 local) {
        const Vec3 direction = frame.to_world(local);
        return is_shadowed(scene, hit, direction) ? 0 : dot(luminance, light->radiance(direction)) * local.y;
    };
    integrand.truth = apply(dense, integrand);
    return integrand;
}

double rms(const std::vector<Verdict>& verdicts, double Verdict::*error) {
    RootMeanSquare rms;
    for (const Verdict& verdict : verdicts) rms.add(verdict.*error);
    return rms.value();
}

}  // namespace

std::vector<Integrand> scene_integrands(const std::shared_ptr<const EnvironmentMap>& light, std::size_t points) {
    const Scene scene = sphere_scene();
    const Camera camera{500, 500};
    const QuadratureRule dense = monte_carlo_rule({Placement::fibonacci, fibonacci_directions(1 << 16)});
    Random random(1, 0);
    std::vector<Integrand> integrands;
    while (integrands.size() < points) {
        const int x = static_cast<int>(500 * random.uniform()), y = static_cast<int>(500 * random.uniform());
        if (const auto hit = intersect(scene, camera.ray(x, y)))
            integrands.push_back(scene_integrand(light, scene, *hit, dense));
    }
    return integrands;
}

Examined examine(const Model& model, double noise, const std::vector<Integrand>& integrands, std::size_t samples,
                 std::size_t sets) {
    Examined examined{model, noise, {}};
    for (std::size_t set = 0; set < sets; ++set) {
        const GaussianProcess process(*model.covariance, noise, estimate_directions({}, samples, set).directions);
        for (const Integrand& integrand : integrands) {
            const std::vector<double> values = sample(integrand, process.directions());
            examined.verdicts.push_back({process.integral(values) - integrand.truth, process.standard_error(values),
                                         process.amplitude(values) > 0 ? -process.log_evidence(values) : 0});
        }
    }
    return examined;
}

double Examined::rmse() const { return rms(verdicts, &Verdict::error); }
double Examined::predicted() const { return rms(verdicts, &Verdict::predicted); }

double Examined::coverage() const {
    Statistics within;
    for (const Verdict& v : verdicts) within.add(std::fabs(v.error) <= 2 * v.predicted);
    return within.mean;
}

Choice choice_by_evidence(const std::vector<Examined>& models) {
    // The model for which value(model) is least.
    const auto least = [&](auto value) -> const Examined& {
        return *std::min_element(models.begin(), models.end(),
                                 [&](const Examined& a, const Examined& b) { return value(a) < value(b); });
    };
    RootMeanSquare error;
    Statistics smooth;
    for (std::size_t i = 0; i < models[0].verdicts.size(); ++i) {
        const Examined& chosen = least([&](const Examined& model) { return model.verdicts[i].surprise; });
        error.add(chosen.verdicts[i].error);
        smooth.add(chosen.model.family == CovarianceFamily::squared_exponential);
    }
    const Examined& pooled = least([&](const Examined& model) {
        double sum = 0;
        for (const Verdict& verdict : model.verdicts) sum += verdict.surprise;
        return sum;
    });
    return {error.value(), smooth.mean, pooled.rmse()};
}

double monte_carlo_rmse(const std::vector<Integrand>& integrands, std::size_t samples, std::size_t sets) {
    RootMeanSquare error;
    for (std::size_t set = 0; set < sets; ++set) {
        const QuadratureRule rule = monte_carlo_rule(estimate_directions({}, samples, set));
        for (const Integrand& integrand : integrands) error.add(apply(rule, integrand) - integrand.truth);
    }
    return error.value();
}

std::string models_report() {
    const std::vector<Column> columns = all_columns();
    return model_table(columns) + choice_table(columns) + coverage_table(columns);
}
}  // namespace bmc
