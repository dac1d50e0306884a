#include "experiments/error_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "quadrature/gaussian_process.h"

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
                row.mc_error +=
                    std::fabs(apply(monte_carlo_rule(directions, settings.placement), integrand) - integrand.truth);
            if (e >= settings.bmc_estimates) continue;
            const std::vector<double> values = sample(integrand, directions, settings.prior.known);
            const GaussianProcess process(covariance, settings.noise, directions, settings.prior);
            row.bmc_error += std::fabs(process.integral(values) - integrand.truth);
            row.bmc_predicted += process.standard_error(values);
            const GaussianProcess rival_process(rival, settings.noise, directions);
            row.rival_error += std::fabs(rival_process.integral(sample(integrand, directions)) - integrand.truth);
        }
        row.mc_error /= static_cast<double>(settings.mc_estimates);
        for (double* mean : {&row.bmc_error, &row.bmc_predicted, &row.rival_error})
            *mean /= static_cast<double>(settings.bmc_estimates);
        rows.push_back(row);
    }
    return rows;
}
