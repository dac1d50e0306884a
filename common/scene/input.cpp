#include "scene/input.h"

#include "command_line.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace bmc {
void fail(std::size_t line, const std::string& problem) {
    throw std::runtime_error("line " + std::to_string(line) + ": " + problem);
}

namespace {

constexpr double largest_number = 1e100;  // so that sums of squares are finite

// A line ends in LF, CR LF or CR; before the first there may be the mark of UTF-8.
bool next_line(std::istream& in, std::string& text, std::size_t line) {
    text.clear();
    if (in.peek() == EOF) return false;
    for (char c; in.get(c) && c != '\n' && c != '\r'; text += c)
        if (text.size() == 4095) fail(line, "it is longer than 4095 characters");
    if (in && in.unget().get() == '\r' && in.peek() == '\n') in.get();
    if (line == 1 && text.compare(0, 3, "\xEF\xBB\xBF") == 0) text.erase(0, 3);
    return true;
}

std::vector<double> numbers_of(std::string text, std::size_t line) {
    if (text.find('\0') < text.size()) fail(line, "it holds a byte 0; this is no text");
    text.erase(std::min(text.find('#'), text.size()));
    std::replace(text.begin(), text.end(), ',', ' ');
    std::istringstream words(text);
    std::vector<double> numbers;
    try {
        for (std::string word; words >> word;) numbers.push_back(parse_real(word, -largest_number, largest_number));
    } catch (const UsageError& error) {
        fail(line, std::string(error.what()) + "; a comment begins with #");
    }
    return numbers;
}

}  // namespace

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

std::vector<InputRow> read_rows(std::istream& in, std::size_t max_rows) {
    std::vector<InputRow> rows;
    std::string text;
    for (std::size_t line = 1; next_line(in, text, line); ++line) {
        InputRow row{line, numbers_of(text, line)};
        if (row.numbers.empty()) continue;
        if (rows.size() == max_rows) fail(line, "there are more than " + std::to_string(max_rows) + " rows of numbers");
        rows.push_back(std::move(row));
    }
    if (rows.empty()) throw std::runtime_error("there are no numbers in it");
    return rows;
}
}  // namespace bmc
