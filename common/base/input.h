// Input from a file, or from standard input.
#pragma once

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace bmc {
// What read(stream) makes of the bytes of a file, or of standard input if the name is "-". Throws std::runtime_error
// with one line, which begins with the name. If the file cannot be opened, it ends with the hint.
template <class Read>
auto read_file(const std::string& name, Read read, const std::string& hint = "") {
    std::ios::sync_with_stdio(false);  // so that std::cin, like a file, throws if it cannot be read
    std::ifstream file(name, std::ios::binary);
    const int reason = errno;
    std::string problem = "it cannot be read to its end";
    try {
        if (name != "-" && !file) throw std::runtime_error(std::strerror(reason) + hint);
        return read(name == "-" ? std::cin : file);
    } catch (const std::ios_base::failure&) {
    } catch (const std::runtime_error& error) {
        problem = error.what();
    }
    throw std::runtime_error((name == "-" ? "standard input" : name) + ": " + problem);
}
}  // namespace bmc
