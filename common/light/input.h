// Files that other programs made, opened by name.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace bmc {
// Calls read with the bytes of the file, or of standard input if its name is "-". Throws std::runtime_error, one line
// that begins with the file's name, if the file cannot be opened or read throws.
void read_input(const std::string& file, const std::function<void(std::istream&)>& read);
}  // namespace bmc
