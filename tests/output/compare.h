// What compare.cpp reads, and its tolerant half.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// Text: lines of columns between white space; a line that begins with # is a header.
std::vector<std::string> split_lines(const std::string& text);
std::vector<std::string> split_columns(const std::string& line);
bool is_row(const std::string& line);

std::string in_words(double value, int digits);
std::string count_of(std::size_t differing, std::size_t all, const char* what);

// A picture of three channels a pixel.
struct Picture {
    bool floats;
    std::size_t width, height;
    std::string header;                   // in one line
    std::vector<std::uint32_t> channels;  // PPM: the bytes; PFM: the bits of the floats

    double value(std::size_t i) const;

    // Where channel 0 of the pixel in column x of row y is; row 0 is the top, and a PFM begins at the bottom.
    std::size_t index(std::size_t x, std::size_t y) const { return 3 * ((floats ? height - 1 - y : y) * width + x); }
};

// An output that another one could be mistaken for.
template <class Output>
struct Named {
    std::string name;
    Output output;
};

// In words, what differs by more than is tolerated; empty if nothing does.
std::string tolerant_text_difference(const std::string& reference, const std::string& actual, double tolerance,
                                     const std::vector<Named<std::string>>& others);
std::string tolerant_picture_difference(const Picture& reference, const Picture& actual,
                                        const std::vector<Named<Picture>>& others);
