// Files that other programs made: opened by name, and tables of numbers read from them.
#pragma once

#include "numerics/portable_math.h"

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace bmc {
// Calls read with the bytes of the file, or of standard input if its name is "-". Throws std::runtime_error, one line
// that begins with the file's name, if the file cannot be opened or read throws.
void read_input(const std::string& file, const std::function<void(std::istream&)>& read);

// Throws std::runtime_error that names the line, from 1.
[[noreturn]] void fail(std::size_t line, const std::string& problem);

// The numbers of one line.
struct InputRow {
    std::size_t line;
    std::vector<double> numbers;
};

// The lines that hold numbers, which white space or commas separate; the rest of a line after '#' is a comment. Lines
// end in LF, CR LF or CR. Throws std::runtime_error that names the line for a word that is no finite number, and for
// none or more than max_rows lines.
std::vector<InputRow> read_rows(std::istream& in, std::size_t max_rows);
}  // namespace bmc
