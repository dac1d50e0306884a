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

TEST_CASE("a long length-scale makes Bayesian Monte Carlo classic: w = 2 pi / (N + noise^2)") {
    for (const double noise : {0.1, 1.0, 10.0}) {
        const GaussianProcess process(SquaredExponential(1e6), noise, sample_set(SampleSet::random, 40));
        // k differs from 1 by r^2 / 2 l^2 < 2e-12, which the condition number N / noise^2 < 4001 amplifies.
        for (const double weight : process.weights())
            CHECK(std::fabs(weight / (2 * pi / (40 + noise * noise)) - 1) < 1e-8);
    }
}

TEST_CASE("duplicates share one weight") {
    std::vector<Vec3> directions = sample_set(SampleSet::random, 20);
    const double noise = 0.1;
    const std::vector<double> alone = GaussianProcess(Sobolev(), noise / std::sqrt(2), directions).weights();
    directions.insert(directions.end(), directions.begin(), directions.end());
    const std::vector<double> twice = GaussianProcess(Sobolev(), noise, directions).weights();
    // Two samples with noise variance v are one with v / 2. The condition number is about 1e4.
    for (std::size_t i = 0; i < 20; ++i) {
        CHECK(std::fabs(twice[i] - twice[i + 20]) < 1e-11);
        CHECK(std::fabs(twice[i] + twice[i + 20] - alone[i]) < 1e-11);
    }
}

TEST_CASE("sample sets are what their names say") {
    for (const Vec3& d : sample_set(SampleSet::equator, 10)) CHECK(d.y == 0);
    for (const Vec3& d : sample_set(SampleSet::pole, 10)) CHECK(d.y == 1);
    const std::vector<Vec3> cluster = sample_set(SampleSet::cluster, 10), twice = sample_set(SampleSet::duplicates, 10);
    for (std::size_t i = 0; i < 10; ++i) {
        CHECK(length(cluster[i] - Vec3{0.48, 0.6, 0.64}) < 1.1e-8);
        CHECK(twice[i].x == twice[i / 2 * 2].x);
    }
}
