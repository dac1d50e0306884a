#include "experiments/rule.h"

#include "test.h"

namespace {

const TextReader<Samples> read{read_samples};

}  // namespace

TEST_CASE("directions are read with or without values, between white space or commas, among comments") {
    const Samples samples = read("# x y z value\r\n0 1 0 2.5\r\n\n0.6,0.8,0,-1e3 # low\n\t0.0 0 -1\t7");
    REQUIRE(samples.directions.size() == 3);
    CHECK(samples.directions[1].x == 0.6);
    CHECK(samples.directions[2].z == -1);
    CHECK(samples.values == std::vector<double>{2.5, -1000, 7});
    CHECK(read("0 1 0\n1 0 0\n").values.empty());
    CHECK(read("0.8000008 0.6 0\n").directions.size() == 1);
    CHECK(read("0,1,0\n0, 1, 0\n0, .6,.8\n").directions.size() == 3);
    // As rule prints them, with z_j and the weight.
    CHECK(read("#  x y z z_j weight\n0 1 0 0.5 0.25\n0.6 0.8 0 0.4 0.3\n").values.empty());
}

TEST_CASE("a line that is no direction is named") {
    const std::string range = "is not a number from -1e+100 to 1e+100";
    CHECK(read.error("0 1 0\n\n0 1 x\n") == "line 3: 'x' " + range);
    CHECK(read.error(std::string("0 1 1\0 2\n", 8)) == "line 1: '1?' " + range);
    for (const std::string word : {"nan", "-inf", "1e308", "0x1p1"})
        CHECK(read.error("0 1 " + word + "\n") == "line 1: '" + word + "' " + range);
    for (const char* text : {"0 1 0\n0 1 0 5\n", "0 1\n0 1\n", "0 1 0 1 1 1\n"})
        CHECK(contains(read.error(text), " numbers; every line should be x y z, or every line x y z value"));
    CHECK(read.error("# up\n0 1.000002 0\n") ==
          "line 2: the direction has length 1.000002; it should be 1 within 1e-6");
    CHECK(read.error("1 -1e-300 0\n") == "line 1: the direction lies below the horizon: its y is -1e-300");
    CHECK(read.error("# nothing\n") == "there are no numbers in it");
    std::string rows;
    for (int i = 0; i < 4096; ++i) rows += "0 1 0\n";
    CHECK(read(rows).directions.size() == 4096);
    CHECK(read.error(rows + "0 1 0\n") == "line 4097: there are more than 4096 directions");
}

TEST_CASE("values that are all zero have no amplitude and no standard error") {
    const Samples samples = read("0 1 0 0\n0.6 0.8 0 0\n");
    const GaussianProcess process(Sobolev(), 0.01, samples.directions);
    CHECK(contains(rule_report(process, Known::nothing, samples.values),
                   "estimate 0, amplitude 0, standard error unknown: zeros tell no amplitude\n"));
}
