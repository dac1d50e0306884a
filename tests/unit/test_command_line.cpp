#include "command_line/command_line.h"
#include "test.h"

TEST_CASE("options take values in both spellings and leave the rest") {
    std::string text;
    double real = 0;
    int whole = 0, flags = 0;
    const Options options =
        joined({Options{text_option("text", "X", "", text), real_option("real", "", real, -1, 2.5)},
                Options{integer_option("whole", "N", "", whole, 4096),
                        {"flag", "", "", [&](const std::string& none) { flags += none.empty(); }}}});
    CHECK(parse({"--text", "3", "rest", "--flag", "--real=-0.5", "--whole", "4096", "-flag"}, options) ==
          std::vector<std::string>{"rest"});
    CHECK(text == "3");
    CHECK(real == -0.5);
    CHECK(whole == 4096);
    CHECK(flags == 2);
}

TEST_CASE("a mistake in an option is a message that names it") {
    std::string text;
    double real = 0;
    int whole = 0;
    const Options options{text_option("text", "X", "", text),
                          real_option("real", "", real, -1, 2.5),
                          integer_option("whole", "N", "", whole, 4096),
                          {"flag", "", "", [](const std::string&) {}}};
    const auto mistake = [&](const std::vector<std::string>& words) {
        CHECK_THROWS_AS(parse(words, options), std::invalid_argument);
        return message_of([&] { parse(words, options); });
    };
    CHECK(mistake({"--other"}) == "there is no option --other; --help lists them all");
    CHECK(mistake({"--text"}) == "--text needs a value; --help shows which");
    CHECK(mistake({"--whole", "0"}) == "--whole: '0' is not a whole number from 1 to 4096");
    CHECK(mistake({"--real=3"}) == "--real: '3' is not a number from -1 to 2.5");
    mistake({"--flag=1"});
}

TEST_CASE("numbers are read entirely or not at all") {
    CHECK(parse_real("0.25", 0, 1) == 0.25);
    CHECK(parse_real("0", 0, 1) == 0);
    CHECK(parse_real("1", 0, 1) == 1);
    for (const char* text : {"", "x", "1x", "1 ", "nan", "inf", "1e400", "-1", "2", "0,5"})
        CHECK_THROWS_AS_MESSAGE(parse_real(text, 0, 1), std::invalid_argument, text);
    CHECK(parse_integer("1", 1, 20) == 1);
    CHECK(parse_integer("20", 1, 20) == 20);
    CHECK(parse_integer("18446744073709551615", 0, UINT64_MAX) == UINT64_MAX);
    for (const char* text : {"", "0", "21", "1.5", "1e1", "18446744073709551617", "-1", "0x10", " 17", "17 "})
        CHECK_THROWS_AS_MESSAGE(parse_integer(text, 1, 20), std::invalid_argument, text);
}

TEST_CASE("a choice is one of the names of a table, which the help lists") {
    enum class Letter { a, b, c };
    constexpr std::pair<const char*, Letter> table[] = {{"b", Letter::b}, {"a", Letter::a}, {"c", Letter::c}},
                                             two[] = {{"a", Letter::a}, {"b", Letter::b}},
                                             alike[] = {{"a", Letter::a}, {"b", Letter::b}, {"a", Letter::c}};
    CHECK(names_all(table));
    CHECK(!names_all(two));
    CHECK(!names_all(alike));
    CHECK(value_of("a", table) == Letter::a);
    CHECK_THROWS_WITH_AS(value_of("d", table), "'d' is not b, a or c", std::invalid_argument);
    CHECK(std::string(name_of(Letter::c, table)) == "c");
    Letter letter = Letter::b;
    const Option choice = enum_option("letter", table, letter, "; a remark");
    CHECK(describe({choice}) == "  --letter NAME        b, a or c (default b); a remark\n");
    choice.set("c");
    CHECK(letter == Letter::c);
}

struct Echo {
    std::string text;
    Options options() { return {text_option("text", "X", "", text)}; }
    std::string report() const { return text; }
};

TEST_CASE("each command has its own options, which set what its report prints") {
    const Command one = command<Echo>("echo", "repeats"), two = command<Echo>("echo", "repeats");
    parse({"--text", "hello"}, one.options);
    CHECK(one.report() == "hello");
    CHECK(two.report() == "");
    CHECK(one.name == "echo");
    CHECK(one.summary == "repeats");
}

TEST_CASE("an exception is a line on standard error, and the exit status 2 or 1") {
    int status = 0;
    const auto run = [&](const std::function<std::string()>& body) {
        const std::string printed = stderr_of([&] { status = run_program("program", body); });
        return printed + std::to_string(status);
    };
    CHECK(run([]() -> std::string { throw std::invalid_argument("a mistake"); }) == "program: a mistake\n2");
    CHECK(run([]() -> std::string { throw std::runtime_error("a problem"); }) == "program: a problem\n1");
    CHECK(run([]() -> std::string { throw std::bad_alloc(); }) == Containing{"there is not enough memory"});
}
