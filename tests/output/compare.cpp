// compare [--tolerant[=T]] REFERENCE ACTUAL: prints where an output first differs from its reference, by how much, and
// how much of it differs. Of pictures, PPM (P3, P6), PFM (PF) or Radiance (.hdr), it measures the error. With
// --tolerant, for the output of another program, numbers agree within a relative T (0.001) plus 1e-9, white space does
// not count, and pictures agree in all but 0.1 % of their pixels.
// compare --objects REFERENCE ACTUAL: of pictures of the sphere scene, made from other random numbers, it prints the
// errors over the pixels that show an object, in linear light.
// Exit status: 0 equal, 1 different, 2 a file cannot be read.
#include "difference.h"

#include "base/input.h"

#include <cstdio>
#include <iterator>

static std::string bytes_of(const char* name) {
    return bmc::read_file(name, [](std::istream& in) { return std::string(std::istreambuf_iterator<char>(in), {}); });
}

int main(int argc, char** argv) {
    try {
        const std::string option = argc > 3 ? argv[1] : "";
        const bool objects = option == "--objects", with_value = option.compare(0, 11, "--tolerant=") == 0;
        if (argc < 3 || argc > 4 || !(option.empty() || objects || with_value || option == "--tolerant"))
            throw std::runtime_error("usage: compare [--tolerant[=T] | --objects] REFERENCE ACTUAL");
        const double tolerance = with_value               ? bmc::parse_real(option.substr(11), 0, 1e9)
                                 : option == "--tolerant" ? 1e-3
                                                          : 0;
        const std::string words = difference(bytes_of(argv[argc - 2]), bytes_of(argv[argc - 1]), tolerance, objects);
        if (words.empty()) return 0;
        std::printf("%s\n", words.c_str());
        return 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "compare: %s\n", error.what());
        return 2;
    }
}
