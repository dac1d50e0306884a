#include "experiments/rule.h"

#include "test.h"

namespace {

const TextReader<Samples> read{read_samples};

// Whether the printed number, of six significant digits at least, is the value.
bool prints(const std::string& word, double value) {
    return std::fabs(std::stod(word) - value) <= 1e-5 * std::fabs(value) + 1e-300;
}

}  // namespace

TEST_CASE("a rule is reported as one row of x, y, z, z_j and weight for each direction") {
    Random random(1, 0);
    const GaussianProcess process(Sobolev(), 0.01, uniform_directions(12, random));
    const auto rows = rows_of(rule_report(process, Known::nothing));
    REQUIRE(rows.size() == 12);
    for (std::size_t i = 0; i < 12; ++i) {
        REQUIRE(rows[i].size() == 5);
        CHECK(std::fabs(std::stod(rows[i][1]) - process.directions()[i].y) < 1e-6);  // of six decimals
        CHECK(prints(rows[i][3], process.z()[i]));
        CHECK(prints(rows[i][4], process.weights()[i]));
    }
}

TEST_CASE("the matrices that are reported are Q, whole, and its inverse, and Q^-1 z are the weights") {
    Rule rule;
    const std::size_t n = rule.samples = 7;
    rule.matrices = true;
    Random random(1, 0);
    const std::vector<Vec3> directions = uniform_directions(n, random);
    const GaussianProcess process(Sobolev(), 0.01, directions);
    const auto rows = rows_of(rule.report());
    REQUIRE(rows.size() == 3 * n);
    for (std::size_t i = 0; i < n; ++i) {
        const auto &of_q = rows[n + i], &of_inverse = rows[2 * n + i];
        REQUIRE(of_q.size() == n);
        REQUIRE(of_inverse.size() == n);
        double weight = 0;
        for (std::size_t j = 0; j < n; ++j) {
            const Vec3 chord = directions[i] - directions[j];
            CHECK(prints(of_q[j], 8.0 / 3 - length(chord) + (i == j ? 1e-4 : 0)));
            weight += std::stod(of_inverse[j]) * process.z()[j];
        }
        CHECK(std::fabs(weight - process.weights()[i]) < 1e-6);  // nine digits of terms of at most 50
    }
}

TEST_CASE("directions are read with or without values, between white space or commas, among comments") {
    const Samples samples = read("# x y z value\r\n0 1 0 2.5\r\n\n0.6,0.8,0,-1e3 # low\n\t0.0 0 -1\t7");
    REQUIRE(samples.directions.size() == 3);
    CHECK(samples.directions[1].x == 0.6);
    CHECK(samples.directions[2].z == -1);
    CHECK(samples.values == std::vector<double>{2.5, -1000, 7});
    CHECK(read("0 1 0\n1 0 0\n").values.empty());
    CHECK(read("0.8000008 0.6 0\n").directions.size() == 1);
    CHECK(read("0,1,0\n0, 1, 0\n0, .6,.8\n").directions.size() == 3);
}

TEST_CASE("directions are read from what rule prints") {
    const Samples own = read("#  x y z z_j weight\n0 1 0 0.5 0.25\n0.6 0.8 0 0.4 0.3\n");
    CHECK(own.directions.size() == 2);
    CHECK(own.values.empty());
}

TEST_CASE("a line that is no direction is named") {
    const std::string range = "is not a number from -1e+100 to 1e+100";
    CHECK(read.error("0 1 0\n\n0 1 x\n") == "line 3: 'x' " + range);
    for (const std::string word : {"nan", "inf", "1e999", "0x1"})
        CHECK(read.error("0 1 " + word + "\n") == "line 1: '" + word + "' " + range);
    for (const char* text : {"0 1 0\n0 1 0 5\n", "0 1\n0 1\n", "0 1 0 1 1 1\n"})
        CHECK(contains(read.error(text), " numbers; every line should be x y z, or every line x y z value"));
    CHECK(read.error("# up\n0 1.000002 0\n") ==
          "line 2: the direction has length 1.000002; it should be 1 within 1e-6");
    CHECK(read.error("0.6 -0.8 0\n") == "line 1: the direction lies below the horizon: its y is -0.8");
    CHECK(read.error("1 -1e-300 0\n") == "line 1: the direction lies below the horizon: its y is -1e-300");
    CHECK(read.error("# nothing\n") == "there are no numbers in it");
    std::string rows;
    for (int i = 0; i < 4096; ++i) rows += "0 1 0\n";
    CHECK(read(rows).directions.size() == 4096);
    CHECK(read.error(rows + "0 1 0\n") == "line 4097: there are more than 4096 directions");
}

TEST_CASE("values are integrated with an error bar, the process's own") {
    const Samples samples = read("0 1 0 3\n0.6 0.8 0 2\n-0.6 0.8 0 2.5\n0 0.6 0.8 1\n0 0.6 -0.8 1.5\n");
    const GaussianProcess process(Sobolev(), 0.01, samples.directions);
    const std::string text = rule_report(process, Known::nothing, samples.values);
    double estimate = 0, amplitude = 0, error = 0;
    const std::size_t at = text.find("estimate ");
    REQUIRE(at != std::string::npos);
    REQUIRE(std::sscanf(text.c_str() + at, "estimate %lf, amplitude %lf, standard error %lf", &estimate, &amplitude,
                        &error) == 3);
    CHECK(std::fabs(estimate - process.integral(samples.values)) < 1e-7);
    CHECK(std::fabs(amplitude - process.amplitude(samples.values)) < 1e-5);
    CHECK(std::fabs(error - process.standard_error(samples.values)) < 1e-5);
    // Five values from 1 to 3: the integral lies between those of the constants 1 and 3.
    CHECK(estimate > 2 * pi);
    CHECK(estimate < 6 * pi);
}

TEST_CASE("values that are all zero have no amplitude and no standard error") {
    const Samples samples = read("0 1 0 0\n0.6 0.8 0 0\n");
    const GaussianProcess process(Sobolev(), 0.01, samples.directions);
    CHECK(contains(rule_report(process, Known::nothing, samples.values),
                   "estimate 0, amplitude 0, standard error unknown: zeros tell no amplitude\n"));
}
