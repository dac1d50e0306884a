// Texts: lines of columns between white space; a line that begins with # is a header.
#include "compare.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <vector>

namespace {

using Words = std::vector<std::string>;

// A reference may have been checked out with Windows line ends; the programs write LF everywhere.
Words split_lines(const std::string& text, bool drop_carriage_returns) {
    Words lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line); lines.push_back(line))
        if (drop_carriage_returns && !line.empty() && line.back() == '\r') line.pop_back();
    return lines;
}

Words split_columns(const std::string& line) {
    std::istringstream in(line);
    return {std::istream_iterator<std::string>(in), {}};
}

bool is_row(const std::string& line) { return line.find_first_not_of(" \t\r") != std::string::npos && line[0] != '#'; }

// A word is a number and what follows it ("0.5;"), or has no number.
struct Word {
    double number;
    std::string rest;
};

Word parse_word(const std::string& text) {
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    return {end == text.c_str() ? NAN : number, end};
}

bool words_agree(const std::string& reference, const std::string& actual, double tolerance) {
    if (reference == actual) return true;
    const Word a = parse_word(reference), b = parse_word(actual);
    return a.rest == b.rest && a.rest.size() < reference.size() && agree(a.number, b.number, tolerance);
}

bool lines_agree(const std::string& reference, const std::string& actual, double tolerance) {
    if (reference == actual || tolerance == 0) return reference == actual;
    const Words a = split_columns(reference), b = split_columns(actual);
    const auto same = [&](const auto& x, const auto& y) { return words_agree(x, y, tolerance); };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

// Where the first difference is: line `at` of both outputs.
std::string describe_place(const Words& reference, const Words& actual, std::size_t at, double tolerance) {
    const auto line_of = [&](const Words& lines) { return at < lines.size() ? lines[at] : "nothing"; };
    const std::string expected = line_of(reference), found = line_of(actual);
    const Words a = split_columns(expected), b = split_columns(found);
    const bool row = is_row(expected) && at < reference.size(), named = row && parse_word(a[0]).rest == a[0];
    const std::string line = "line " + std::to_string(at + 1) + (named ? ", " + a[0] : "");
    if (a == b) return line + ", reference: " + expected + ": only white space differs";
    if (!row || a.size() != b.size()) return line + ", reference: " + expected + ", here: " + found;
    std::size_t i = 0;
    while (words_agree(a[i], b[i], tolerance)) ++i;
    const auto rows = std::count_if(reference.data(), reference.data() + at + 1, is_row);
    return "row " + std::to_string(rows) + " (" + line + "), column " + std::to_string(i + 1) + ": reference " + a[i] +
           ", here " + b[i];
}

}  // namespace

std::string text_difference(const std::string& reference, const std::string& actual, double tolerance) {
    const Words expected = split_lines(reference, true), found = split_lines(actual, false);
    const std::size_t lines = std::max(expected.size(), found.size()), common = std::min(expected.size(), found.size());
    std::size_t first = lines, differing = lines - common;
    for (std::size_t i = lines; i-- > 0;)
        if (i >= common || !lines_agree(expected[i], found[i], tolerance)) {
            first = i;
            if (i < common) ++differing;
        }
    const bool ends_alike = reference.empty() || actual.empty() || reference.back() == actual.back();
    if (differing == 0) return ends_alike || tolerance > 0 ? "" : "only the line end after the last line differs";
    const std::string text = describe_place(expected, found, first, tolerance);
    if (expected.size() != found.size())
        return bmc::formatted("%s; the reference has %zu lines, here are %zu", text.c_str(), expected.size(),
                              found.size());
    return text + "; " + count_of(differing, lines, "lines");
}
