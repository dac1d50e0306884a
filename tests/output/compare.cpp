// compare [--tolerant[=T]] REFERENCE ACTUAL: says in words where an output differs from its reference first, by how
// much, how much differs, and what the differences have in common. Knows text tables, PPM (P6) and PFM (PF). With
// --tolerant, for the output of another program, numbers agree within a relative T (0.001) plus 1e-9, white space does
// not count, and pictures agree in all but 0.1 % of their pixels. Exit status: 0 equal, 1 different, 2 a file cannot be
// read.
#include "compare.h"

#include "../course/judge/likely_mistakes.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

std::string reason(double ratio) {
    for (const bmc::Factor& each : bmc::factors)
        if (std::fabs(ratio / each.factor - 1) <= 0.005) return std::string(" (") + each.name + ")";
    return "";
}

namespace {

std::string read_file(const char* name) {
    std::ifstream in(name, std::ios::binary);
    std::ostringstream content;
    if (in.peek() != EOF) content << in.rdbuf();
    if (!in.is_open() || in.bad() || content.fail()) throw std::runtime_error(std::string("cannot read ") + name);
    return content.str();
}

double tolerance_of(const std::string& option) {
    if (option == "--tolerant") return 1e-3;
    char* end = nullptr;
    const double tolerance = option.compare(0, 11, "--tolerant=") == 0 ? std::strtod(&option[11], &end) : -1;
    if (!(tolerance >= 0) || end == &option[11] || *end != '\0')
        throw std::runtime_error(option + " is no --tolerant=NUMBER");
    return tolerance;
}

std::string difference(const std::string& reference, const std::string& actual, double tolerance) {
    if (reference == actual) return "";
    return reference[0] == 'P' ? picture_difference(reference, actual, tolerance)
                               : text_difference(reference, actual, tolerance);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        if (argc < 3 || argc > 4) throw std::runtime_error("usage: compare [--tolerant[=T]] REFERENCE ACTUAL");
        const double tolerance = argc == 4 ? tolerance_of(argv[1]) : 0;
        const std::string words = difference(read_file(argv[argc - 2]), read_file(argv[argc - 1]), tolerance);
        if (!words.empty()) std::printf("%s\n", words.c_str());
        return words.empty() ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "compare: %s\n", error.what());
        return 2;
    }
}
