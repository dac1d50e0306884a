#include "command_line/command_line.h"
#include "test.h"

struct Values {
    std::string text;
    double real = 0;
    std::size_t whole = 0;
    bool flag = false;
    Options options;

    Values() {
        options.add("text", "X", "", text);
        options.add("real", "X", "", real, -1, 2.5);
        options.add("whole", "N", "", whole, 1, 4096);
        options.add("flag", "", flag);
    }
};

TEST_CASE("options take values in both spellings and leave the rest") {
    const Values values;
    CHECK(parse({"--text", "3", "rest", "--flag", "--real=-0.5", "--wh", "4096"}, values.options) ==
          std::vector<std::string>{"rest"});
    CHECK(values.text == "3");
    CHECK(values.real == -0.5);
    CHECK(values.whole == 4096);
    CHECK(values.flag);
    CHECK(!Values().flag);
}

TEST_CASE("an option has one name, and can be replaced by it") {
    Values values;
    CHECK(&values.options.named("real") == &values.options.all[1]);
    CHECK_THROWS_WITH(values.options.named("rea"), "there is no option rea");
}

TEST_CASE("a mistake in an option is a message that names it") {
    const Values values;
    const Options& options = values.options;
    const auto mistake = [&](const std::vector<std::string>& words) {
        CHECK_THROWS_AS(parse(words, options), std::invalid_argument);
        return message_of([&] { parse(words, options); });
    };
    CHECK(mistake({"--other=1"}) == "there is no option --other; --help lists them all");
    for (const std::string single : {"-t", "-text", "-w4"})
        CHECK(mistake({single, "4"}) == "there is no option " + single.substr(0, 2) +
                                            "; options begin with two dashes, and --help lists them all");
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"--text"}, {"--tex"}, {"--text="}, {"--text", ""}, {"--text", "--flag"}, {"--text", "--"}})
        CHECK(mistake(words) == "--text needs a value; --help shows which");
    parse({"--text", "-"}, options);
    CHECK(values.text == "-");
    parse({"--text=--flag"}, options);
    CHECK(values.text == "--flag");
    CHECK(mistake({"--whole", "0"}) == "--whole: '0' is not a whole number from 1 to 4096");
    CHECK(mistake({"--real=3"}) == "--real: '3' is not a number from -1 to 2.5");
    CHECK(mistake({"--flag=1"}) == "--flag takes no value");
}

TEST_CASE("an option may be shortened as long as one name begins so") {
    std::string text;
    Options alike;
    for (const char* name : {"same", "seed", "seed-two", "other"}) alike.add(name, "X", "", text);
    CHECK(message_of([&] { parse({"--s=1"}, alike); }) == "--s is ambiguous: --same, --seed or --seed-two");
    CHECK(parse({"--seed=1", "--sa=2"}, alike).empty());
    CHECK(text == "2");
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
    enum class Letter { b, a, c };
    constexpr const char* table[] = {"b", "a", "c"};
    CHECK(std::string(name_of(Letter::c, table)) == "c");
    Letter letter = Letter::b;
    Options options;
    options.add("letter", table, letter, "; a remark");
    CHECK(describe(options) == "  --letter NAME        b, a or c (default b); a remark\n");
    CHECK(message_of([&] { parse({"--letter=d"}, options); }) == "--letter: 'd' is not b, a or c");
    parse({"--letter=c"}, options);
    CHECK(letter == Letter::c);
}

TEST_CASE("a note is one line without control characters, the middle left out if long") {
    const auto shown = [](const std::string& text) { return stderr_of([&] { print_note(text); }); };
    CHECK(shown("a\nb\r\x1b[2J\x7f\xc2\x9b \xc3\x9c") == Containing{": a?b??[2J?\xc2? \xc3\x9c\n"});
    const std::string ends = shown("first" + std::string(100000, 'x') + "last");
    CHECK(ends == Containing{": first" + std::string(295, 'x') + " ... " + std::string(296, 'x') + "last\n"});
    CHECK(shown(std::string(600, 'x')) == Containing{": " + std::string(600, 'x') + "\n"});
}
