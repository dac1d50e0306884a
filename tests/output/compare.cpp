// compare [--tolerant[=T]] REFERENCE ACTUAL: prints where an output first differs from its reference, by how much, and
// how much of it differs. Of pictures, PPM (P6) or PFM (PF), it measures the error. With --tolerant, for the output of
// another program, numbers agree within a relative T (0.001) plus 1e-9, white space does not count, and pictures agree
// in all but 0.1 % of their pixels. Exit status: 0 equal, 1 different, 2 a file cannot be read.
#include "difference.h"

#include "base/input.h"
#include "command_line/command_line.h"

#include <cstdio>
#include <iterator>

static std::string content_of(const char* name) {
    return bmc::read_file(name, [](std::istream& in) { return std::string(std::istreambuf_iterator<char>(in), {}); });
}

static double tolerance_of(const std::string& option) {
    if (option == "--tolerant") return 1e-3;
    if (option.compare(0, 11, "--tolerant=") != 0) throw std::invalid_argument("there is no option " + option);
    return bmc::parse_real(option.substr(11), 0, 1e9);
}

int main(int argc, char** argv) {
    try {
        const bool tolerant = argc > 1 && argv[1][0] == '-';
        if (argc != 3 + tolerant) throw std::runtime_error("usage: compare [--tolerant[=T]] REFERENCE ACTUAL");
        const double tolerance = tolerant ? tolerance_of(argv[1]) : 0;
        const std::string reference = content_of(argv[1 + tolerant]), actual = content_of(argv[2 + tolerant]);
        const std::string words = difference(reference, actual, tolerance);
        if (words.empty()) return 0;
        std::printf("%s\n", words.c_str());
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "compare: %s\n", error.what());
        return 2;
    }
}
