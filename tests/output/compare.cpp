// compare REFERENCE ACTUAL: says in words what changed first between an output and its reference, by how much, and how
// much changed. Knows text tables, PPM (P6) and PFM (PF). Exit status: 0 equal, 1 different, 2 a file cannot be read.
//
// compare --tolerant[=T] REFERENCE ACTUAL [NAME=FILE]...: the same for the output of another program. Numbers agree
// within a relative T (0.001) plus 1e-9, pictures in all but 0.1 % of their pixels; what differs is told as a person
// would see it. NAME=FILE is an output that the other could be mistaken for.
#include "compare.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

std::string in_words(double value, int digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    return text;
}

std::string count_of(std::size_t differing, std::size_t all, const char* what) {
    return std::to_string(differing) + " of " + std::to_string(all) + " " + what +
           (differing == 1 ? " differs" : " differ");
}

std::vector<std::string> split_lines(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::vector<std::string> split_columns(const std::string& line) {
    std::istringstream in(line);
    return {std::istream_iterator<std::string>(in), {}};
}

bool is_row(const std::string& line) { return line.find_first_not_of(" \t\r") != std::string::npos && line[0] != '#'; }

double Picture::value(std::size_t i) const {
    if (!floats) return channels[i];
    float number;
    std::memcpy(&number, &channels[i], sizeof number);
    return static_cast<double>(number);
}

namespace {

std::string read_file(const char* name) {
    std::ifstream in(name, std::ios::binary);
    std::ostringstream content;
    if (in.peek() != EOF) content << in.rdbuf();
    if (!in.is_open() || in.bad() || content.fail()) throw std::runtime_error(std::string("cannot read ") + name);
    return content.str();
}

// ---- Text

std::optional<double> number(const std::string& text) {
    char* end = nullptr;
    const double value = std::strtod(text.c_str(), &end);
    return text.empty() || *end != '\0' ? std::nullopt : std::optional<double>(value);
}

// Where two rows differ; nothing if they have no column by column difference and have to be shown whole.
std::optional<std::string> row_difference(const std::string& reference, const std::string& actual) {
    const std::vector<std::string> expected = split_columns(reference), found = split_columns(actual);
    if (expected.size() != found.size() || expected == found) return std::nullopt;
    std::size_t i = 0;
    while (expected[i] == found[i]) ++i;
    std::string text = "column " + std::to_string(i + 1) + ": reference " + expected[i] + ", here " + found[i];
    const std::optional<double> a = number(expected[i]), b = number(found[i]);
    if (a && b) text += ", differs by " + in_words(std::fabs(*b - *a), 3);
    return text;
}

std::string describe_lines(const std::vector<std::string>& reference, const std::vector<std::string>& actual,
                           std::size_t first) {
    const auto at = [&](const auto& lines) { return first < lines.size() ? lines[first] : "nothing"; };
    const std::string line = "line " + std::to_string(first + 1), expected = at(reference), found = at(actual);
    const bool rows = first < std::min(reference.size(), actual.size()) && is_row(expected) && is_row(found);
    const auto difference = rows ? row_difference(expected, found) : std::nullopt;
    const char* const note = split_columns(expected) == split_columns(found) ? " (only white space differs)" : "";
    if (!difference) return line + ", reference: " + expected + "\n" + line + ", here:      " + found + note;
    const auto row = std::count_if(reference.data(), reference.data() + first + 1, is_row);
    return "row " + std::to_string(row) + " (" + line + "), " + *difference;
}

// A reference may have been checked out with Windows line ends; the programs write LF everywhere.
std::string without_carriage_returns(std::string text) {
    for (std::size_t at = 0; (at = text.find("\r\n", at)) != std::string::npos;) text.erase(at, 1);
    return text;
}

std::string text_difference(const std::string& reference_file, const std::string& actual_text) {
    const std::string reference_text = without_carriage_returns(reference_file);
    if (reference_text == actual_text) return "";
    const std::vector<std::string> reference = split_lines(reference_text), actual = split_lines(actual_text);
    const std::size_t lines = std::max(reference.size(), actual.size());
    std::size_t first = lines, differing = 0;
    for (std::size_t i = 0; i < lines; ++i)
        if (i >= reference.size() || i >= actual.size() || reference[i] != actual[i]) {
            first = std::min(first, i);
            ++differing;
        }
    if (differing == 0) return "only the line end after the last line differs";
    std::string text = describe_lines(reference, actual, first) + "; " + count_of(differing, lines, "lines");
    if (reference.size() != actual.size())
        text += " (reference: " + std::to_string(reference.size()) + ", here: " + std::to_string(actual.size()) + ")";
    return text;
}

// ---- Pictures

// The sign of a PFM's scale says which byte comes first, whatever the order of this machine.
std::uint32_t word_at(const std::string& bytes, std::size_t at, bool little_endian) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
        word = word << 8 | static_cast<unsigned char>(bytes[little_endian ? at + 3 - k : at + k]);
    return word;
}

std::optional<Picture> parse_picture(const std::string& bytes) {
    std::istringstream in(bytes);
    std::string magic, top;
    std::size_t width = 0, height = 0;
    if (!(in >> magic >> width >> height >> top) || std::max(width, height) > 9999 || in.get() < 0) return std::nullopt;
    const bool floats = magic == "PF";
    const double scale = number(top).value_or(0);  // PPM: the largest value of a channel
    if ((!floats && magic != "P6") || !(floats ? scale != 0 : scale == 255)) return std::nullopt;
    const std::size_t begin = static_cast<std::size_t>(in.tellg()), size = floats ? 4 : 1, count = 3 * width * height;
    if (bytes.size() != begin + size * count) return std::nullopt;
    Picture picture{floats, width, height, bytes.substr(0, begin - 1), std::vector<std::uint32_t>(count)};
    std::replace(picture.header.begin(), picture.header.end(), '\n', ' ');
    for (std::size_t i = 0; i < count; ++i)
        picture.channels[i] =
            floats ? word_at(bytes, begin + 4 * i, scale < 0) : static_cast<unsigned char>(bytes[begin + i]);
    return picture;
}

std::string describe_channel(const Picture& reference, const Picture& actual, std::size_t i) {
    const std::size_t x = i / 3 % reference.width,
                      y = reference.index(0, i / 3 / reference.width) / 3 / reference.width;
    const char* const colours[] = {"red", "green", "blue"};
    return "pixel (x " + std::to_string(x) + ", y " + std::to_string(y) + "), " + colours[i % 3] + ": reference " +
           in_words(reference.value(i), 9) + ", here " + in_words(actual.value(i), 9);
}

// The picture to compare with the reference, or in words why there is none.
std::string picture_problem(const Picture& reference, const std::optional<Picture>& actual, std::size_t bytes) {
    if (!actual)
        return "reference: a picture (" + reference.header + "), here: " + std::to_string(bytes) +
               " bytes that are not a complete one";
    return reference.header == actual->header ? ""
                                              : "header: reference " + reference.header + ", here " + actual->header;
}

std::string picture_difference(const Picture& reference, const Picture& actual) {
    const std::size_t channels = reference.channels.size();
    std::size_t first = channels, differing = 0, last_pixel = channels;
    double largest = 0;
    for (std::size_t i = 0; i < channels; ++i) {
        if (reference.channels[i] == actual.channels[i]) continue;
        first = std::min(first, i);
        if (i / 3 != std::exchange(last_pixel, i / 3)) ++differing;
        largest = std::fmax(largest, std::fabs(reference.value(i) - actual.value(i)));  // passes over a nan
    }
    if (differing == 0) return "only the white space in the header differs";
    return describe_channel(reference, actual, first) + "; " +
           count_of(differing, reference.width * reference.height, "pixels") + ", at most by " + in_words(largest, 3);
}

struct Request {
    std::optional<double> tolerance;
    std::vector<std::string> files;          // reference, actual
    std::vector<Named<std::string>> others;  // contents
};

Request parse(int argc, char** argv) {
    Request request;
    int i = 1;
    if (i < argc && std::strncmp(argv[i], "--tolerant", 10) == 0) {
        const std::string option = argv[i++];
        request.tolerance =
            option == "--tolerant" ? 1e-3 : number(option.substr(std::min(option.size(), std::size_t{11})));
        if (!request.tolerance || !(*request.tolerance >= 0))
            throw std::runtime_error(option + " is no --tolerant=NUMBER");
    }
    for (; i < argc && request.files.size() < 2; ++i) request.files.push_back(argv[i]);
    for (; i < argc && request.tolerance; ++i) {
        const std::string word = argv[i];
        const std::size_t equals = word.rfind('=');
        if (equals == std::string::npos) throw std::runtime_error(word + " is no NAME=FILE");
        request.others.push_back({word.substr(0, equals), read_file(word.c_str() + equals + 1)});
    }
    if (i < argc || request.files.size() < 2)
        throw std::runtime_error(
            "usage: compare REFERENCE ACTUAL, or compare --tolerant[=T] REFERENCE ACTUAL [NAME=FILE]...");
    return request;
}

std::string difference(const Request& request, const std::string& reference, const std::string& actual) {
    const std::optional<Picture> expected = parse_picture(reference);
    if (!expected && reference.compare(0, 1, "P") == 0)
        throw std::runtime_error(request.files[0] + " is a damaged picture (were its line ends converted?)");
    if (!expected && request.tolerance)
        return tolerant_text_difference(reference, actual, *request.tolerance, request.others);
    if (!expected) return text_difference(reference, actual);
    const std::optional<Picture> found = parse_picture(actual);
    const std::string problem = picture_problem(*expected, found, actual.size());
    if (!problem.empty()) return problem;
    if (!request.tolerance) return picture_difference(*expected, *found);
    std::vector<Named<Picture>> others;
    for (const Named<std::string>& other : request.others)
        if (const std::optional<Picture> picture = parse_picture(other.output))
            others.push_back({other.name, *picture});
    return tolerant_picture_difference(*expected, *found, others);
}

int compare(const Request& request) {
    const std::string reference = read_file(request.files[0].c_str()), actual = read_file(request.files[1].c_str());
    if (reference == actual) return 0;
    const std::string words = difference(request, reference, actual);
    if (!words.empty()) std::printf("%s\n", words.c_str());
    return words.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return compare(parse(argc, argv));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "compare: %s\n", error.what());
        return 2;
    }
}
