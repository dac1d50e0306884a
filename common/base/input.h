// Input from a file, or from standard input.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

namespace bmc {
// What read(stream) makes of the bytes of a file, or of standard input if its name is "-". Throws std::runtime_error:
// one line that begins with the name. missing: what it says of a file that cannot be opened.
template <class Read>
auto read_file(const std::string& name, Read read, const std::string& missing = "there is no such file") {
    std::ifstream file(name, std::ios::binary);
#ifdef _WIN32
    if (name == "-") _setmode(STDIN_FILENO, _O_BINARY);
#endif
    std::string problem = "it cannot be read to its end";
    try {
        if (name != "-" && !file) throw std::runtime_error(missing);
        auto content = read(name == "-" ? std::cin : file);
        if (!std::ferror(stdin)) return content;
    } catch (const std::ios_base::failure&) {
    } catch (const std::runtime_error& error) {
        if (!std::ferror(stdin)) problem = error.what();
    }
    throw std::runtime_error((name == "-" ? "standard input" : name) + ": " + problem);
}
}  // namespace bmc
