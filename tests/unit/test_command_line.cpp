#include "command_line.h"

#include "test.h"

TEST_CASE("options take values in both spellings and leave the rest") {
    std::string value;
    bool flag = false;
    const std::vector<Option> options = {{"value", "X", "", [&](const std::string& text) { value = text; }},
                                         {"flag", "", "", [&](const std::string&) { flag = true; }}};
    CHECK(parse({"--value", "3", "rest", "--flag"}, options) == std::vector<std::string>{"rest"});
    CHECK(value == "3");
    CHECK(flag);
    CHECK(parse({"--value=4"}, options).empty());
    CHECK(value == "4");
    CHECK_THROWS_WITH_AS(parse({"--other"}, options), "there is no option --other; --help lists them all", UsageError);
    CHECK_THROWS_WITH_AS(parse({"--value"}, options), "--value needs a value; --help shows which", UsageError);
    CHECK_THROWS_AS(parse({"--flag=1"}, options), UsageError);
    CHECK_THROWS_AS(parse({"-v"}, options), UsageError);
    const Option samples{"samples", "N", "", [](const std::string& text) { parse_integer(text, 1, 4096); }};
    CHECK_THROWS_WITH_AS(parse({"--samples", "0"}, {samples}), "--samples: '0' is not a whole number from 1 to 4096",
                         UsageError);
}

TEST_CASE("an option that would change nothing is refused, whatever stands before or after it") {
    bool used = false;
    const std::vector<Option> options = {
        {"use", "", "", [&](const std::string&) { used = true; }},
        {"value", "X", "", [](const std::string&) {}, [&] { return used ? "" : "it belongs to --use"; }}};
    CHECK_THROWS_WITH_AS(parse({"--value", "3"}, options),
                         "--value would change nothing: it belongs to --use; leave it out", UsageError);
    CHECK_NOTHROW(parse({"--value", "3", "--use"}, options));
    CHECK_NOTHROW(parse({"--use", "--value", "3"}, options));
}

TEST_CASE("numbers are read entirely or not at all") {
    CHECK(parse_real("0.25", 0, 1) == 0.25);
    CHECK(parse_real("1e-3", 0, 1) == 0.001);
    for (const char* text :
         {"", "x", "1x", "1 ", "nan", "inf", "-inf", "1e400", "-1", "2", "0,5", "--", " 0.5", "0.5 ", "\t1", "0x1p-4"})
        CHECK_THROWS_AS(parse_real(text, 0, 1), UsageError);
    CHECK(parse_integer("17", 1, 20) == 17);
    for (const char* text :
         {"", "0", "21", "1.5", "1e1", "99999999999999999999", "-1", "0x10", "nan", " 17", "17 ", "\n17"})
        CHECK_THROWS_AS(parse_integer(text, 1, 20), UsageError);
    CHECK(parse_seed("0") == 0);
    CHECK(parse_seed("18446744073709551615") == ~std::uint64_t{0});
    for (const char* text : {"-1", " 1", "1 ", "18446744073709551616"}) CHECK_THROWS_AS(parse_seed(text), UsageError);
}

TEST_CASE("a choice is one of the names of a table, and the help lists them") {
    constexpr std::pair<const char*, int> table[] = {{"a", 1}, {"b", 2}, {"c", 3}};
    CHECK(parse_choice("b", table) == 2);
    CHECK_THROWS_WITH_AS(parse_choice("d", table), "'d' is none of a, b, c", UsageError);
    CHECK(std::string(name_of(3, table)) == "c");
    CHECK(choices(table, 1) == "a (default), b or c");
}

TEST_CASE("the length-scale among a model's options is that of its covariance") {
    ModelSettings settings;
    parse({"--covariance", "squared-exponential", "--length-scale", "0.5"}, ModelOptions(settings).process);
    CHECK((*settings.make_covariance())(0.75) == SquaredExponential(0.5)(0.75));
}
