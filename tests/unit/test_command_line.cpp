#include "command_line/command_line.h"

#include "base/terminal.h"
#include "test.h"

struct Values {
    std::string text;
    double real = 0;
    std::size_t whole = 0;
    bool flag = false;
    Arguments options;

    Values() {
        options.add("text", "X", "", text);
        options.add("real", "X", "", real, -1, 2.5);
        options.add("whole", "N", "", whole, 1, 4096);
        options.add("flag", "", flag);
    }
};

TEST_CASE("options take values in both spellings and leave the rest") {
    Values values;
    CHECK(parse({"--text", "3", "rest", "--flag", "--real=-0.5", "--whole", "4096"}, values.options) ==
          std::vector<std::string>{"rest"});
    CHECK(values.text == "3");
    CHECK(values.real == -0.5);
    CHECK(values.whole == 4096);
    CHECK(values.flag);
    CHECK(!Values().flag);
}

TEST_CASE("a mistake in an option is a message that names it") {
    Values values;
    Arguments& options = values.options;
    const auto mistake = [&](const std::vector<std::string>& words) {
        CHECK_THROWS_AS(parse(words, options), std::invalid_argument);
        return message_of([&] { parse(words, options); });
    };
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"--text"}, {"--text="}, {"--text", ""}, {"--text", "--flag"}, {"--text", "--"}})
        CHECK(mistake(words) == "--text needs a value; --help shows which");
    parse({"--text", "-"}, options);
    CHECK(values.text == "-");
    parse({"--text=--flag"}, options);
    CHECK(values.text == "--flag");
    CHECK(mistake({"--whole", "0"}) == "--whole N: '0' is not a whole number from 1 to 4096");
    CHECK(mistake({"--flag=1"}) == "--flag takes no value");
    CHECK(mistake({"--tex", "3"}) == "there is no option --tex; --help lists them all");
}

TEST_CASE("numbers are read entirely or not at all") {
    for (const char* text : {"0", "0.25", "1"}) CHECK(parse_real(text, 0, 1) == std::atof(text));
    for (const char* text : {"", "x", "1x", "1 ", "nan", "inf", "1e400", "1e-400", "-1", "2", "0,5"})
        CHECK_THROWS_AS_MESSAGE(parse_real(text, 0, 1), std::invalid_argument, text);
    for (const std::uint64_t whole : {std::uint64_t{1}, UINT64_MAX})
        CHECK(parse_integer(std::to_string(whole), 1, whole) == whole);
    for (const char* text : {"", "0", "21", "1.5", "1e1", "18446744073709551617", "-1", "0x10", " 17", "17 "})
        CHECK_THROWS_AS_MESSAGE(parse_integer(text, 1, 20), std::invalid_argument, text);
    CHECK_THROWS_AS(parse_integer("18446744073709551616", 0, UINT64_MAX), std::invalid_argument);  // 2^64
}

TEST_CASE("a note is one line without control characters") {
    CHECK(stderr_of([] { print_note("a\nb\r\x1b[2J\x7f \xc3\x9c"); }) == Containing{": a?b??[2J? \xc3\x9c\n"});
}

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
