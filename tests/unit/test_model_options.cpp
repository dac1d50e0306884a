#include "command_line/model_options.h"
#include "test.h"

TEST_CASE("the options of a model take the ranges of a process") {
    ModelSettings s;
    Options options;
    add_model_options(options, s);
    check_ranges(options,
                 {"--smoothness=1.001", "--length-scale=0.05", "--length-scale=1e6", "--noise=0", "--seed=0",
                  "--smoothness=1.999", "--noise=1000", "--seed=18446744073709551615",
                  "--covariance=squared-exponential", "--known=cosine", "--placement=cosine-fibonacci"},
                 {"--smoothness=1.0005", "--smoothness=1.9995", "--length-scale=0.0499", "--length-scale=1.1e6",
                  "--noise=-1e-9", "--noise=1001", "--seed=-1", "--known=all"});
}

TEST_CASE("the known part is the density of the placement, unless it is given, before or after") {
    const auto known_of = [](const std::vector<std::string>& words) {
        ModelSettings s;
        Options options;
        add_model_options(options, s);
        parse(words, options);
        return s.make_covariance()->known();
    };
    CHECK(known_of({}) == Known::nothing);
    CHECK(known_of({"--placement=cosine-stratified"}) == Known::cosine);
    CHECK(known_of({"--placement=cosine", "--known=nothing"}) == Known::nothing);
    CHECK(known_of({"--known=nothing", "--placement=cosine-fibonacci"}) == Known::nothing);
    CHECK(known_of({"--known=cosine", "--placement=fibonacci"}) == Known::cosine);
}
