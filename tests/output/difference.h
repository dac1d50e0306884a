// What differs between an output and its reference, word by word: the words of a text, or the numbers of a picture.
#pragma once

#include "base/formatted.h"
#include "scene/image.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

struct Words {
    std::vector<std::string> all;    // of a picture three for each pixel, row after row, the top one first
    std::vector<std::size_t> lines;  // of a text: where each word stands
    std::string picture;             // its kind and size; empty for a text
    std::size_t width = 0;
};

// The float of a PFM at this place. The sign of the scale says which byte comes first, whatever this machine does.
inline double float_at(const std::string& bytes, std::size_t at, double scale) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
        word = word << 8 | static_cast<unsigned char>(bytes[scale < 0 ? at + 3 - k : at + k]);
    return std::fabs(scale) * static_cast<double>(bmc::portable::bit_cast<float>(word));
}

// Of a PPM (P6, or P3, its text form), or of a PFM (PF). Throws std::runtime_error unless it is complete.
inline Words words_of_picture(const std::string& bytes) {
    Words words;
    std::istringstream in(bytes);
    std::string magic, word, rest;
    std::size_t height = 0;
    double top = 0;  // the largest code; of a PFM a factor
    in >> magic >> words.width >> height >> top;
    if (in.get() >= 0) rest = bytes.substr(static_cast<std::size_t>(in.tellg()));
    const std::size_t row = 3 * words.width, count = std::max(words.width, height) < 65536 ? row * height : 0;
    words.picture = bmc::formatted("%zu x %zu, ", words.width, height) +
                    (magic == "PF" ? "floats" : bmc::formatted("codes up to %g", top));
    if (magic == "PF" && rest.size() == 4 * count)
        for (std::size_t i = 0; i < count; ++i)  // from the bottom row up
            words.all.push_back(
                bmc::formatted("%.9g", float_at(rest, 4 * ((height - 1 - i / row) * row + i % row), top)));
    if (magic == "P6")
        for (const char code : rest) words.all.push_back(std::to_string(static_cast<unsigned char>(code)));
    if (magic == "P3")
        while (in >> word) words.all.push_back(word);
    if (words.all.size() != count || count == 0)
        throw std::runtime_error(words.picture + ", but it ends early or late (was it written in text mode?)");
    return words;
}

inline Words words_of(const std::string& bytes) {
    if (bytes[0] == 'P') return words_of_picture(bytes);
    Words words;
    std::istringstream in(bytes);
    std::size_t number = 1;
    for (std::string line, word; std::getline(in, line); ++number)
        for (std::istringstream columns(line); columns >> word; words.lines.push_back(number))
            words.all.push_back(word);
    return words;
}

// Whether a word may stand in the place of the reference's: a number, with what follows it ("0.5;"), that differs by at
// most the relative tolerance plus 1e-9.
inline bool agree(const std::string& reference, const std::string& actual, double tolerance) {
    if (reference == actual || tolerance == 0) return reference == actual;
    char *end_a = nullptr, *end_b = nullptr;
    const double a = std::strtod(reference.c_str(), &end_a), b = std::strtod(actual.c_str(), &end_b);
    return end_a != reference.c_str() && end_b != actual.c_str() && std::string(end_a) == end_b &&
           std::fabs(a - b) <= tolerance * std::fabs(a) + 1e-9;
}

// Of pixels, which begin at these words: the error of their linear light, and of its mean.
inline std::string errors_of(const Words& reference, const Words& actual, const std::vector<std::size_t>& pixels) {
    const bool floats = reference.picture.find("floats") != std::string::npos;
    const auto light = [&](const std::string& word) {
        const double number = std::strtod(word.c_str(), nullptr);
        return floats ? number : bmc::srgb_to_linear(number / 255);
    };
    double squares = 0, sum = 0, expected = 0;
    for (const std::size_t pixel : pixels)
        for (std::size_t i = pixel; i < pixel + 3; ++i) {
            const double error = light(actual.all[i]) - light(reference.all[i]);
            squares += error * error;
            sum += error;
            expected += light(reference.all[i]);
        }
    if (!std::isfinite(squares / expected)) return "";
    return bmc::formatted("; there the RMSE is %.3g, the brightness is off by %+.1f %%",
                          std::sqrt(squares / (3 * static_cast<double>(pixels.size()))), 100 * sum / expected);
}

// In words; empty if nothing differs. With a tolerance (which codes do not have) one pixel in a thousand may differ,
// and white space. Without one all bytes are the same.
inline std::string difference(const std::string& reference, const std::string& actual, double tolerance) {
    if (reference == actual) return "";
    const Words expected = words_of(reference);
    Words found;
    try {
        found = words_of(actual);
    } catch (const std::runtime_error& error) {
        return std::string("here is no complete picture: ") + error.what();
    }
    if (expected.picture != found.picture)
        return "reference: " + expected.picture + ", here: " + (found.picture.empty() ? "no picture" : found.picture);
    const bool codes = expected.picture.find("codes") != std::string::npos, text = expected.picture.empty();
    const std::size_t step = text ? 1 : 3, all = std::max(expected.all.size(), found.all.size());
    const auto word = [](const Words& words, std::size_t i) { return i < words.all.size() ? words.all[i] : "nothing"; };
    const auto same = [&](std::size_t i) { return agree(word(expected, i), word(found, i), codes ? 0 : tolerance); };
    std::vector<std::size_t> differing;  // words of a text, or pixels
    for (std::size_t i = 0; i < all; i += step)
        if (!same(i) || (!text && !(same(i + 1) && same(i + 2)))) differing.push_back(i);
    if (differing.size() <= (tolerance > 0 && !text ? all / step / 1000 : 0))
        return tolerance > 0 ? "" : "no word differs, but white space, or the form of the numbers";
    std::size_t i = differing[0];
    const std::string place =
        text ? bmc::formatted("line %zu", (i < expected.lines.size() ? expected : found).lines[i])
             : bmc::formatted("pixel (x %zu, y %zu)", i / 3 % expected.width, i / 3 / expected.width);
    while (same(i)) ++i;
    return place + ": reference " + word(expected, i) + ", here " + word(found, i) +
           bmc::formatted("; %zu of %zu %s differ", differing.size(), all / step, text ? "words" : "pixels") +
           (text ? "" : errors_of(expected, found, differing));
}
