#include "experiments/models.h"

#include "experiments/root_mean_square.h"
#include "experiments/scene_integrands.h"
#include "quadrature/gaussian_process.h"
#include "scene/desert.h"

#include <algorithm>
#include <cmath>

namespace {

// What is integrated in a column of the tables, over so many sets of directions: of one integrand more than of many.
struct Column {
    std::string name;
    std::vector<Integrand> integrands;
    std::size_t sets;
};

std::vector<Column> columns() {
    std::vector<Column> all{{"cosine", {practice_integrands()[1]}, 1000}};
    for (const std::string& name : built_in_lights())
        all.push_back(
            {name, scene_integrands(std::make_shared<const EnvironmentMap>(load_environment(name)), 100), 10});
    return all;
}

struct NoisyModel {
    Model model;
    double noise;
};

std::vector<NoisyModel> compared_models() {
    std::vector<NoisyModel> models;
    for (const double s : {1.1, 1.25, 1.4, 1.5, 1.8}) models.push_back({{CovarianceFamily::sobolev, s}, 1e-2});
    for (const double noise : {1e-3, 1e-1}) models.push_back({{CovarianceFamily::sobolev, 1.5}, noise});
    for (const double noise : {1e-2, 1e-1})
        for (const double l : {0.25, 0.5, 1.0, 2.0})
            models.push_back({{CovarianceFamily::squared_exponential, l}, noise});
    return models;
}

constexpr std::size_t standard_model = 3;  // Sobolev 3/2, noise 0.01
constexpr std::size_t n = 40;

std::string heading(const std::vector<Column>& all) {
    std::string text;
    for (const Column& column : all) text += line(" %15s", column.name.c_str());
    return text + '\n';
}

// judged[c] holds the models' verdicts on column c.
std::string model_table(const std::vector<Column>& all, const std::vector<std::vector<Judged>>& judged) {
    std::string text =
        "# Which model? Root mean square errors with 40 samples: of cos(theta), and of incident radiance "
        "times cos(theta)\n# at 100 points of the scene, drawn at random, under each light.\n"
        "# covariance        parameter  noise" +
        heading(all);
    for (std::size_t i = 0; i < judged[0].size(); ++i) {
        const Judged& first = judged[0][i];
        text += line("%-20s %8g %6g", first.model.name(), first.model.parameter, first.noise);
        for (const std::vector<Judged>& column : judged) text += line(" %15.4g", column[i].rmse());
        text += '\n';
    }
    text += "monte-carlo                 -      -";
    for (const Column& column : all) text += line(" %15.4g", monte_carlo_rmse(column.integrands, n, column.sets));
    return text + '\n';
}

std::string choice_table(const std::vector<Column>& all, const std::vector<std::vector<Judged>>& judged) {
    std::string text =
        "\n\n# What do the samples choose of these models, without the truth? The RMSE of Sobolev 3/2 with "
        "noise 0.01; of the\n# model that one set of 40 values chooses, and how often it is "
        "squared-exponential; and of the one that all sets\n# choose: by the evidence, then by the "
        "leave-one-out error.\n"
        "# integrand       sobolev_3/2   evidence  smooth  pooled  leave_one_out  smooth  pooled\n";
    for (std::size_t c = 0; c < all.size(); ++c) {
        const Choice evidence = choice_by(&Verdict::surprise, judged[c]),
                     left_out = choice_by(&Verdict::leave_one_out, judged[c]);
        text += line("%-16s %12.4g %10.4g %7.2f %7.4g %14.4g %7.2f %7.4g\n", all[c].name.c_str(),
                     judged[c][standard_model].rmse(), evidence.rmse, evidence.smooth, evidence.pooled_rmse,
                     left_out.rmse, left_out.smooth, left_out.pooled_rmse);
    }
    return text;
}

std::string coverage_table(const std::vector<Column>& all) {
    std::string text =
        "\n\n# Is the error bar honest? Fraction of errors within two predicted standard errors, and "
        "predicted over actual RMSE.\n# samples";
    for (const Column& column : all) text += line(" %15s %6s", column.name.c_str(), "ratio");
    text += '\n';
    for (const std::size_t count : {2u, 5u, 10u, 20u, 40u, 80u, 160u}) {
        text += line("%9zu", count);
        for (const Column& column : all) {
            const Judged judged = judge({CovarianceFamily::sobolev, 1.5}, 1e-2, column.integrands, count, column.sets);
            text += line(" %15.3f %6.2f", judged.coverage(), judged.predicted() / judged.rmse());
        }
        text += '\n';
    }
    return text;
}

}  // namespace

Judged judge(const Model& model, double noise, const std::vector<Integrand>& integrands, std::size_t samples,
             std::size_t sets) {
    Judged judged{model, noise, {}};
    for (std::size_t set = 0; set < sets; ++set) {
        const GaussianProcess process(*model.covariance, noise, estimate_directions({}, samples, set).directions);
        const Matrix inverse = process.inverse_covariance();
        for (const Integrand& integrand : integrands) {
            const std::vector<double> values = sample(integrand, process.directions());
            double left_out = 0;
            for (const double residual : process.leave_one_out(values, inverse)) left_out += residual * residual;
            judged.verdicts.push_back({process.integral(values) - integrand.truth, process.standard_error(values),
                                       -process.log_evidence(values), left_out / static_cast<double>(samples)});
        }
    }
    return judged;
}

double Judged::rmse() const {
    RootMeanSquare error;
    for (const Verdict& verdict : verdicts) error.add(verdict.error);
    return error.value();
}

double Judged::predicted() const {
    RootMeanSquare error;
    for (const Verdict& verdict : verdicts) error.add(verdict.predicted);
    return error.value();
}

double Judged::coverage() const {
    const auto within = std::count_if(verdicts.begin(), verdicts.end(),
                                      [](const Verdict& v) { return std::fabs(v.error) <= 2 * v.predicted; });
    return static_cast<double>(within) / static_cast<double>(verdicts.size());
}

Choice choice_by(double Verdict::*criterion, const std::vector<Judged>& models) {
    RootMeanSquare error;
    double smooth = 0;
    for (std::size_t i = 0; i < models[0].verdicts.size(); ++i) {
        const Judged& chosen = *std::min_element(models.begin(), models.end(), [&](const Judged& a, const Judged& b) {
            return a.verdicts[i].*criterion < b.verdicts[i].*criterion;
        });
        error.add(chosen.verdicts[i].error);
        smooth += chosen.model.family == CovarianceFamily::squared_exponential;
    }
    const auto sum = [&](const Judged& model) {
        double all = 0;
        for (const Verdict& verdict : model.verdicts) all += verdict.*criterion;
        return all;
    };
    const Judged& pooled = *std::min_element(models.begin(), models.end(),
                                             [&](const Judged& a, const Judged& b) { return sum(a) < sum(b); });
    return {error.value(), smooth / error.count, pooled.rmse()};
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
    const std::vector<Column> all = columns();
    std::vector<std::vector<Judged>> judged(all.size());
    for (std::size_t c = 0; c < all.size(); ++c)
        for (const NoisyModel& compared : compared_models())
            judged[c].push_back(judge(compared.model, compared.noise, all[c].integrands, n, all[c].sets));
    return model_table(all, judged) + choice_table(all, judged) + coverage_table(all);
}
