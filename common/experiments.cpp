#include "experiments.h"

#include "environment.h"
#include "gaussian_process.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

using portable::pi;

namespace {

std::vector<double> sample(const Integrand& integrand, const std::vector<Vec3>& directions) {
    std::vector<double> values;
    values.reserve(directions.size());
    for (const Vec3& direction : directions) values.push_back(integrand.value(direction));
    return values;
}

double apply(const QuadratureRule& rule, const Integrand& integrand) {
    double sum = 0;
    for (std::size_t i = 0; i < rule.weights.size(); ++i) sum += rule.weights[i] * integrand.value(rule.directions[i]);
    return sum;
}

// Luminance (Rec. 709) of the light that a surface facing the arch and the sky reflects, times cos(theta).
Integrand environment_integrand() {
    const auto environment = std::make_shared<const EnvironmentMap>(built_in_environment());
    const Frame frame(normalize({0.3, 0.6, -0.7}));
    Integrand integrand{"environment", "L(w) cos(theta), the built-in environment above a tilted surface", nullptr, 0};
    integrand.value = [=](Vec3 direction) {
        const Color radiance = environment->radiance(frame.to_world(direction));
        return dot({0.2126, 0.7152, 0.0722}, radiance) * direction.y;
    };
    integrand.truth = apply(monte_carlo_rule(fibonacci_directions(1 << 18)), integrand);
    return integrand;
}

}  // namespace

std::vector<Integrand> practice_integrands() {
    return {{"constant", "1", [](Vec3) { return 1.0; }, 2 * pi},
            {"cosine", "cos(theta)", [](Vec3 w) { return w.y; }, pi},
            {"cosine-cubed", "cos(theta)^3", [](Vec3 w) { return w.y * w.y * w.y; }, pi / 2},
            environment_integrand()};
}

double ErrorRow::gain() const {
    if (bmc_error > 0) return mc_error / bmc_error;
    return mc_error > 0 ? std::numeric_limits<double>::infinity() : 1;
}

std::vector<ErrorRow> error_table(const Integrand& integrand, const Covariance& covariance, const Covariance& rival,
                                  const ErrorSettings& settings) {
    std::vector<ErrorRow> rows;
    for (const std::size_t n : settings.samples) {
        ErrorRow row{n, 0, 0, 0, 0};
        for (std::size_t e = 0; e < std::max(settings.mc_estimates, settings.bmc_estimates); ++e) {
            Random random(settings.seed, (std::uint64_t{n} << 32) + e);
            const std::vector<Vec3> directions = place_directions(settings.placement, n, random);
            if (e < settings.mc_estimates)
                row.mc_error += std::fabs(apply(monte_carlo_rule(directions), integrand) - integrand.truth);
            if (e >= settings.bmc_estimates) continue;
            const std::vector<double> values = sample(integrand, directions);
            const GaussianProcess process(covariance, settings.noise, directions);
            row.bmc_error += std::fabs(process.integral(values) - integrand.truth);
            row.bmc_predicted += process.standard_error(values);
            const GaussianProcess rival_process(rival, settings.noise, directions);
            row.rival_error += std::fabs(rival_process.integral(values) - integrand.truth);
        }
        row.mc_error /= static_cast<double>(settings.mc_estimates);
        for (double* mean : {&row.bmc_error, &row.bmc_predicted, &row.rival_error})
            *mean /= static_cast<double>(settings.bmc_estimates);
        rows.push_back(row);
    }
    return rows;
}
