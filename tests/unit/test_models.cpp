#include "experiments/models.h"
#include "experiments/scene_integrands.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {

const Model rough{CovarianceFamily::sobolev, 1.5};
const Model smooth{CovarianceFamily::squared_exponential, 1};

}  // namespace

TEST_CASE("the smooth covariance wins on the smooth cosine, and evidence and leave-one-out know it") {
    const std::vector<Integrand> cosine{practice_integrands()[1]};
    const ModelRow sobolev = judge(rough, 0.01, {cosine}, 40, 100)[0],
                   exponential = judge(smooth, 0.01, {cosine}, 40, 100)[0];
    CHECK(exponential.rmse < 0.3 * sobolev.rmse);
    CHECK(exponential.log_evidence > sobolev.log_evidence + 1);
    CHECK(exponential.leave_one_out < 0.3 * sobolev.leave_one_out);
}

TEST_CASE("the rough covariance wins on radiance, and evidence and leave-one-out know it") {
    const std::vector<Integrand> radiance = scene_integrands();
    const ModelRow sobolev = judge(rough, 0.01, {radiance}, 40, 100)[0],
                   exponential = judge(smooth, 0.01, {radiance}, 40, 100)[0];
    CHECK(exponential.rmse > 1.3 * sobolev.rmse);
    CHECK(exponential.log_evidence < sobolev.log_evidence - 0.3);
    CHECK(exponential.leave_one_out > 1.3 * sobolev.leave_one_out);
    CHECK(exponential.amplification > 1.3);
    CHECK(sobolev.amplification < 1.05);
}

TEST_CASE("85 to 99.9 percent of the errors on radiance lie within two predicted standard errors") {
    const std::vector<Integrand> radiance = scene_integrands();
    for (const std::size_t n : {std::size_t{20}, std::size_t{40}, std::size_t{80}}) {
        const double coverage = judge(rough, 0.01, {radiance}, n, 200)[0].coverage;
        CHECK(coverage >= 0.85);
        CHECK(coverage <= 0.999);
    }
}

TEST_CASE("the RMSE of Monte Carlo is what its variance says") {
    // cos(theta) has variance 1/12 under the uniform density; 400 sets leave a relative standard error of 1 /
    // sqrt(800).
    const double expected = 2 * portable::pi * std::sqrt(1.0 / 12 / 40);
    CHECK(std::fabs(monte_carlo_rmse({practice_integrands()[1]}, 40, 400) / expected - 1) < 5 / std::sqrt(800.0));
}

TEST_CASE("a zero mean makes a constant too small, and too large what vanishes at the horizon") {
    const Bias constant = bias_of({practice_integrands()[0]}, 20, 400),
               cosine = bias_of({practice_integrands()[1]}, 20, 400);
    CHECK(constant.mean < -5 * constant.standard_error);
    CHECK(cosine.mean > 3 * cosine.standard_error);
}
