#include "experiments/stability.h"

#include "test.h"

namespace {

const Model rough(CovarianceFamily::sobolev, 1.5), smooth(CovarianceFamily::squared_exponential, 1);

}  // namespace

TEST_CASE("the error found by turning is within 20 times of the true one, by weights of 60 digits") {
    std::ifstream in("tests/unit/weights.txt");
    std::string line, set, family;
    double noise = 0, weight = 0;
    int settings = 0;
    while (std::getline(in, line)) {
        if (line[0] == '#') continue;
        std::istringstream words(line);
        words >> set >> family >> noise;
        const SampleSet its_set = parse_choice(set, sample_set_names);
        const Model& model = family == "sobolev" ? rough : smooth;
        const std::vector<double> weights =
            GaussianProcess(*model.covariance, noise, sample_set(its_set, 40)).weights();
        double error = 0, largest = 0;
        for (const double each : weights) {
            REQUIRE(static_cast<bool>(words >> weight));
            error = std::max(error, std::fabs(each - weight));
            largest = std::max(largest, std::fabs(weight));
        }
        CAPTURE(line.substr(0, 40));
        // Measured: a ratio from 0.2 to 12. In the cluster exp(-r^2 / 2) rounds to 1, turned or not.
        const double ratio = weight_error(sample_set(its_set, 40), model, noise).value() / (error / largest);
        if (its_set == SampleSet::cluster && &model == &smooth && noise == 1e-6)
            CHECK(ratio < 1e-3);
        else
            CHECK(std::fabs(std::log(ratio)) < std::log(20));
        ++settings;
    }
    CHECK(settings == 30);
}

TEST_CASE("a factor of a singular matrix gives no correct digit") {
    CHECK(weight_error(sample_set(SampleSet::random, 100), smooth, 0).value() >= 0.1);
}

TEST_CASE("what is singular in double precision is refused, naming the pivot, and works with noise") {
    for (const SampleSet set : {SampleSet::duplicates, SampleSet::pole}) {
        CHECK(
            contains(message_of([&] { Cholesky(covariance_matrix(Sobolev(), 0, sample_set(set, 100))); }), "pivot 1 "));
        CHECK(!weight_error(sample_set(set, 100), rough, 0));
        CHECK(weight_error(sample_set(set, 100), rough, 1e-2).value() < 1e-9);
    }
    // As s tends to 2, k tends to C - r^2, of rank 4: constants and the three coordinates.
    const Model nearly_flat{CovarianceFamily::sobolev, std::nextafter(2, 1)};
    CHECK(!weight_error(sample_set(SampleSet::random, 100), nearly_flat, 0));
    CHECK(weight_error(sample_set(SampleSet::random, 100), nearly_flat, 1e-2));
}
