#include "experiments/models.h"

#include "test.h"

namespace {

const Model rough{CovarianceFamily::sobolev, 1.5};
const Model smooth{CovarianceFamily::squared_exponential, 1};

std::vector<Integrand> radiance() {
    return scene_integrands(std::make_shared<const EnvironmentMap>(load_environment()), 10);
}

std::vector<Examined> both(const std::vector<Integrand>& integrands, std::size_t sets) {
    return {examine(rough, 0.01, integrands, 40, sets), examine(smooth, 0.01, integrands, 40, sets)};
}

}  // namespace

TEST_CASE("the rough covariance wins on radiance, and most but not all sets of samples know it") {
    const std::vector<Examined> models = both(radiance(), 20);
    CHECK(models[1].rmse() > 1.2 * models[0].rmse());
    const Choice choice = choice_by_evidence(models);
    CHECK(choice.smooth > 0.02);
    CHECK(choice.smooth < 0.5);
    CHECK(choice.pooled_rmse == models[0].rmse());
}

TEST_CASE("a set of zeros says nothing about a model") {
    Integrand rare{"rare", "", [](Vec3 w) { return w.x > 0.98 ? 1.0 : 0.0; }, 0};
    const std::vector<Examined> models = both({rare}, 50);
    int zeros = 0;
    for (const Verdict& verdict : models[0].verdicts) zeros += verdict.predicted == 0 && verdict.surprise == 0;
    CHECK(zeros > 10);  // a direction misses the cap with the probability 0.99
    CHECK(zeros < 50);
    double sums[2] = {};
    for (std::size_t i = 0; i < 2; ++i)
        for (const Verdict& verdict : models[i].verdicts) sums[i] += verdict.surprise;
    CHECK(std::isfinite(sums[0]));
    CHECK(choice_by_evidence(models).pooled_rmse == models[sums[1] < sums[0]].rmse());
}
