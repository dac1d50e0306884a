#include "experiments/models.h"

#include "quadrature/gaussian_process.h"

#include <cmath>

using portable::pi;

namespace {

std::vector<Vec3> sample_set(std::size_t n, std::size_t set) {
    Random random(1, (std::uint64_t{n} << 32) + set);
    return uniform_directions(n, random);
}

}  // namespace

std::vector<Model> compared_models() {
    std::vector<Model> models;
    for (double s : {1.1, 1.25, 1.4, 1.5, 1.8}) models.push_back({"sobolev", s, std::make_shared<Sobolev>(s)});
    for (double l : {0.25, 0.5, 1.0, 2.0})
        models.push_back({"squared-exponential", l, std::make_shared<SquaredExponential>(l)});
    return models;
}

ModelRow judge(const Model& model, double noise, const std::vector<Integrand>& integrands, std::size_t n,
               std::size_t sets) {
    ModelRow row{model, noise, 0, 0, 0, 0, 0, 0};
    for (std::size_t set = 0; set < sets; ++set) {
        const GaussianProcess process(*model.covariance, noise, sample_set(n, set));
        for (const double weight : process.weights()) row.amplification += std::fabs(weight) / (2 * pi);
        for (const Integrand& integrand : integrands) {
            const std::vector<double> values = sample(integrand, process.directions());
            const double error = process.integral(values) - integrand.truth, predicted = process.standard_error(values);
            row.rmse += error * error;
            row.predicted += predicted * predicted;
            row.coverage += std::fabs(error) <= 2 * predicted;
            row.log_evidence += process.log_evidence(values) / static_cast<double>(n);
            for (const double residual : process.leave_one_out(values))
                row.leave_one_out += residual * residual / static_cast<double>(n);
        }
    }
    const double estimates = static_cast<double>(sets * integrands.size());
    row.rmse = std::sqrt(row.rmse / estimates);
    row.predicted = std::sqrt(row.predicted / estimates);
    row.coverage /= estimates;
    row.log_evidence /= estimates;
    row.leave_one_out = std::sqrt(row.leave_one_out / estimates);
    row.amplification /= static_cast<double>(sets);
    return row;
}

double monte_carlo_rmse(const std::vector<Integrand>& integrands, std::size_t n, std::size_t sets) {
    double squares = 0;
    for (std::size_t set = 0; set < sets; ++set) {
        const QuadratureRule rule = monte_carlo_rule(sample_set(n, set));
        for (const Integrand& integrand : integrands) {
            const double error = apply(rule, integrand) - integrand.truth;
            squares += error * error;
        }
    }
    return std::sqrt(squares / static_cast<double>(sets * integrands.size()));
}
