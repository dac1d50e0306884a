#include "experiments/models.h"

#include "experiments/statistics.h"
#include "quadrature/gaussian_process.h"
#include "scene/desert.h"
#include "scene/scene.h"

#include <algorithm>
#include <cmath>

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

// What is integrated in a column of the tables, over so many sets of directions, and what comes of it by each model.
struct Column {
    std::string name;
    std::vector<Integrand> integrands;
    std::size_t sets;
    std::vector<Judged> judged;
};

std::vector<Column> all_columns() {
    std::vector<Column> columns{{"cosine", {practice_integrands()[1]}, 1000, {}}};
    for (const std::string& name : built_in_lights()) {
        const auto light = std::make_shared<const EnvironmentMap>(load_environment(name));
        columns.push_back({name, scene_integrands(light, 100), 10, {}});
    }
    for (Column& column : columns)
        for (const auto& [model, noise] : models_and_noises())
            column.judged.push_back(judge(model, noise, column.integrands, n, column.sets));
    return columns;
}

std::string model_table(const std::vector<Column>& columns) {
    std::string text =
        "# Which model? Root mean square errors with 40 samples: of cos(theta), and of incident radiance "
        "times cos(theta)\n# at 100 points of the scene, drawn at random, under each light.\n"
        "# covariance        parameter  noise";
    for (const Column& column : columns) text += line(" %15s", column.name.c_str());
    text += '\n';
    for (std::size_t i = 0; i < columns[0].judged.size(); ++i) {
        const auto& [model, noise, verdicts] = columns[0].judged[i];
        text += line("%-20s %8g %6g", name_of(model.family, covariance_names), model.parameter, noise);
        for (const Column& column : columns) text += line(" %15.4g", column.judged[i].rmse());
        text += '\n';
    }
    text += "monte-carlo                 -      -";
    for (const Column& column : columns) text += line(" %15.4g", monte_carlo_rmse(column.integrands, n, column.sets));
    return text + '\n';
}

std::string choice_table(const std::vector<Column>& columns) {
    std::string text =
        "\n\n# What do the samples choose of these models, without the truth? The RMSE of Sobolev 3/2 with "
        "noise 0.01; of the\n# model that one set of 40 values chooses, and how often it is "
        "squared-exponential; and of the one that all sets\n# choose: by the evidence, then by the "
        "leave-one-out error.\n"
        "# integrand       sobolev_3/2   evidence  smooth  pooled  leave_one_out  smooth  pooled\n";
    for (const Column& column : columns) {
        const Choice evidence = choice_by(&Verdict::surprise, column.judged),
                     left_out = choice_by(&Verdict::leave_one_out, column.judged);
        text += line("%-16s %12.4g %10.4g %7.2f %7.4g %14.4g %7.2f %7.4g\n", column.name.c_str(),
                     column.judged[standard_model].rmse(), evidence.rmse, evidence.smooth, evidence.pooled_rmse,
                     left_out.rmse, left_out.smooth, left_out.pooled_rmse);
    }
    return text;
}

std::string coverage_table(const std::vector<Column>& columns) {
    std::string text =
        "\n\n# Is the error bar honest? Fraction of errors within two predicted standard errors, and "
        "predicted over actual RMSE.\n# samples";
    for (const Column& column : columns) text += line(" %15s %6s", column.name.c_str(), "ratio");
    text += '\n';
    for (const std::size_t count : {2u, 5u, 10u, 20u, 40u, 80u, 160u}) {
        text += line("%9zu", count);
        for (const Column& column : columns) {
            const Judged judged = judge({CovarianceFamily::sobolev, 1.5}, 1e-2, column.integrands, count, column.sets);
            text += line(" %15.3f %6.2f", judged.coverage(), judged.predicted() / judged.rmse());
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

Judged judge(const Model& model, double noise, const std::vector<Integrand>& integrands, std::size_t samples,
             std::size_t sets) {
    Judged judged{model, noise, {}};
    for (std::size_t set = 0; set < sets; ++set) {
        const GaussianProcess process(*model.covariance, noise, estimate_directions({}, samples, set).directions);
        const Matrix inverse = process.inverse_covariance();
        for (const Integrand& integrand : integrands) {
            const std::vector<double> values = sample(integrand, process.directions());
            Statistics squares;
            for (const double residual : process.leave_one_out(values, inverse)) squares.add(residual * residual);
            judged.verdicts.push_back({process.integral(values) - integrand.truth, process.standard_error(values),
                                       -process.log_evidence(values), squares.mean});
        }
    }
    return judged;
}

double Judged::rmse() const { return rms(verdicts, &Verdict::error); }
double Judged::predicted() const { return rms(verdicts, &Verdict::predicted); }

double Judged::coverage() const {
    Statistics within;
    for (const Verdict& v : verdicts) within.add(std::fabs(v.error) <= 2 * v.predicted);
    return within.mean;
}

Choice choice_by(double Verdict::*criterion, const std::vector<Judged>& models) {
    // The model for which value(model) is least.
    const auto least = [&](auto value) -> const Judged& {
        return *std::min_element(models.begin(), models.end(),
                                 [&](const Judged& a, const Judged& b) { return value(a) < value(b); });
    };
    RootMeanSquare error;
    Statistics smooth;
    for (std::size_t i = 0; i < models[0].verdicts.size(); ++i) {
        const Judged& chosen = least([&](const Judged& model) { return model.verdicts[i].*criterion; });
        error.add(chosen.verdicts[i].error);
        smooth.add(chosen.model.family == CovarianceFamily::squared_exponential);
    }
    const Judged& pooled = least([&](const Judged& model) {
        double sum = 0;
        for (const Verdict& verdict : model.verdicts) sum += verdict.*criterion;
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

std::string Models::report() const {
    const std::vector<Column> columns = all_columns();
    return model_table(columns) + choice_table(columns) + coverage_table(columns);
}
