#include "command_line/command_line.h"
#include "test.h"

static ModelSettings model_of(const std::vector<std::string>& words) {
    ModelSettings settings;
    Arguments arguments;
    add_model_options(arguments, settings);
    parse(words, arguments);
    return settings;
}

TEST_CASE("the options of a model set its members, in the ranges of a process") {
    for (const std::string word :
         {"--smoothness=1.001", "--smoothness=1.999", "--length-scale=0.05", "--length-scale=1e6", "--noise=0",
          "--noise=1000", "--seed=0", "--seed=18446744073709551615"})
        CHECK_MESSAGE(message_of([&] { model_of({word}); }) == "", word);
    for (const std::string word : {"--smoothness=1.0005", "--smoothness=1.9995", "--length-scale=0.0499",
                                   "--length-scale=1.1e6", "--noise=-1e-9", "--noise=1001", "--seed=-1"})
        CHECK_THROWS_AS_MESSAGE(model_of({word}), std::invalid_argument, word);
}

TEST_CASE("the cosine is known if the density of the placement is the cosine, unless it is given, before or after") {
    const auto known = [](const std::vector<std::string>& words) {
        return std::string(name_of(model_of(words).make_covariance()->known, known_names));
    };
    CHECK(known({}) == "nothing");
    CHECK(known({"--placement=cosine-stratified"}) == "cosine");
    CHECK(known({"--placement=cosine", "--known=nothing"}) == "nothing");
    CHECK(known({"--known=nothing", "--placement=cosine-fibonacci"}) == "nothing");
    CHECK(known({"--known=cosine", "--placement=fibonacci"}) == "cosine");
}
