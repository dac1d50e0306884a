// verdict EXPECTED ACTUAL: compares the lines that check_tasks prints with those of the solution, and says which number
// is the first that differs. Exit status: 0 none, 1 one, 2 ACTUAL has no number where it should have one, 3 a file
// cannot be read. Of ACTUAL only names and numbers are read.
// verdict --all EXPECTED ACTUAL prints every number, the right one, and a star where they differ.
#include "base/formatted.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <sstream>
#include <vector>

using bmc::formatted;

namespace {

constexpr double pi = 3.14159265358979323846;

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, '\t');) cells.push_back(cell);
    return cells;
}

bool same(double a, double b) { return std::isfinite(b) && std::fabs(a - b) <= 1e-6 * std::fabs(b); }

// A plain relation between two numbers, if there is one. With one sample n times a number is the number itself.
std::string relation(double here, double right, double n) {
    if (!std::isfinite(here) || right == 0 || here == 0) return "";
    if (std::fabs(here - right) < 1e-5 * std::fabs(right)) return " (nearly: is something a float?)";
    if (same(here, -right)) return " (the other sign)";
    const std::pair<const char*, double> factors[] = {
        {"2", 2}, {"pi", pi}, {"2 pi", 2 * pi}, {"n", n}, {"n / (n - 1)", n / (n - 1)}};
    for (const auto& [words, factor] : factors) {
        if (same(here, factor * right)) return formatted(" (%s times it)", words);
        if (same(here, right / factor)) return formatted(" (it over %s)", words);
    }
    if (same(here, right * right)) return " (its square)";
    return same(here, std::sqrt(std::fabs(right))) ? " (its root)" : "";
}

// The line has a name, what is right, the difference allowed, n, and numbers of mistakes, each with its words.
std::string difference(const std::vector<std::string>& line, double here) {
    const auto number = [&](std::size_t i) { return std::strtod(line[i].c_str(), nullptr); };
    const double right = number(1);
    if (std::fabs(here - right) <= number(2)) return "";
    std::string why = relation(here, right, number(3));
    for (std::size_t i = 5; i < line.size(); i += 2)
        if (same(here, number(i - 1)) && !same(right, number(i - 1))) why = ": " + line[i];
    return line[0] + formatted(" is %.9g, right is %.9g", here, right) + why;
}

}  // namespace

int main(int argc, char** argv) {
    const bool all = argc == 4 && std::string(argv[1]) == "--all";
    std::ifstream expected(argc == 3 + all ? argv[1 + all] : ""), actual(argc == 3 + all ? argv[2 + all] : "");
    std::map<std::string, std::string> numbers;
    for (std::string line; std::getline(actual, line);) {
        const std::vector<std::string> cells = cells_of(line);
        if (cells.size() > 1) numbers.emplace(cells[0], cells[1]);
    }
    std::size_t lines = 0;
    int status = 0;
    if (all) std::cout << formatted("  %18s %18s\n", "here", "right");
    for (std::string line; std::getline(expected, line); ++lines) {
        const std::vector<std::string> cells = cells_of(line);
        const auto found = numbers.find(cells.at(0));
        char* end = nullptr;
        const double here = found == numbers.end() ? NAN : std::strtod(found->second.c_str(), &end);
        const bool is_number = end && end != found->second.c_str() && *end == '\0';
        const std::string words = is_number ? difference(cells, here) : cells[0];
        if (all)
            std::cout << (words.empty() ? ' ' : '*')
                      << formatted(" %18s %18s  ", is_number ? found->second.c_str() : "none", cells[1].c_str())
                      << cells[0] << '\n';
        else if (!words.empty())
            std::cout << words << '\n';
        if (!words.empty() && status == 0) status = is_number ? 1 : 2;
        if (status != 0 && !all) return status;
    }
    return lines > 0 ? status : 3;
}
