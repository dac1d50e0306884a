#include "light/input.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace bmc {
void read_input(const std::string& file, const std::function<void(std::istream&)>& read) {
    try {
        if (file == "-") return read(std::cin);
        if (std::filesystem::is_directory(file)) throw std::runtime_error("this is a directory; name a file");
        std::ifstream in(file, std::ios::binary);
        if (!in) throw std::runtime_error(std::string("cannot open this file: ") + std::strerror(errno));
        read(in);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error((file == "-" ? "standard input" : file) + ": " + error.what());
    }
}
}  // namespace bmc
