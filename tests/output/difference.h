// What differs between an output and its reference, word by word: the words of a text, or the numbers of a picture, a
// PPM, a PFM or a Radiance picture.
#pragma once

#include "experiments/reports.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

struct Words {
    std::vector<std::string> all;       // of a picture three for each pixel, row after row, the top one first
    std::vector<std::size_t> lines;     // of a text: where each word stands
    std::size_t width = 0, height = 0;  // of a picture
    double white = 0;                   // its largest code; 0 for floats

    bool is_picture() const { return width > 0; }
    std::string kind() const {
        if (!is_picture()) return "no picture";
        return bmc::formatted("%zu x %zu, ", width, height) +
               (white > 0 ? bmc::formatted("codes up to %g", white) : "floats");
    }
    double light(std::size_t i) const {  // linear
        const double number = std::strtod(all[i].c_str(), nullptr);
        return white > 0 ? bmc::srgb_to_linear(number / white) : number;
    }
};

// The float of a PFM at this place. The sign of the scale says which byte comes first, whatever this machine does.
inline double float_at(const std::string& bytes, std::size_t at, double scale) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
        word = word << 8 | static_cast<unsigned char>(bytes[scale < 0 ? at + 3 - k : at + k]);
    return std::fabs(scale) * static_cast<double>(bmc::portable::bit_cast<float>(word));
}

inline bool is_pnm(const std::string& bytes) {
    return bytes.compare(0, 2, "P3") == 0 || bytes.compare(0, 2, "P6") == 0 || bytes.compare(0, 2, "PF") == 0;
}

// The header of a PPM has four words, and may have comments, such as GIMP's: lines that begin with #.
inline std::string without_comments(std::string bytes) {
    const auto is_space = [&](std::size_t i) { return std::isspace(static_cast<unsigned char>(bytes[i])) != 0; };
    for (std::size_t i = 2, words = 1; is_pnm(bytes) && words < 4 && i < bytes.size();)
        if (bytes[i] == '#' && is_space(i - 1)) {
            bytes.erase(i, bytes.find('\n', i) - i + 1);
        } else {
            if (is_space(i - 1) && !is_space(i)) ++words;
            ++i;
        }
    return bytes;
}

// Of a PPM (P6, or P3, its text form), or of a PFM (PF). Throws std::runtime_error unless it is complete.
inline Words words_of_picture(const std::string& bytes) {
    Words words;
    std::istringstream in(bytes);
    std::string magic, word, rest;
    double top = 0;  // the largest code; of a PFM a factor
    in >> magic >> words.width >> words.height >> top;
    if (in.get() >= 0) rest = bytes.substr(static_cast<std::size_t>(in.tellg()));
    const std::size_t row = 3 * words.width;
    const std::size_t count = std::max(words.width, words.height) < 65536 ? row * words.height : 0;
    if (magic == "PF" && rest.size() == 4 * count)
        for (std::size_t i = 0; i < count; ++i)  // from the bottom row up
            words.all.push_back(
                bmc::formatted("%.9g", float_at(rest, 4 * ((words.height - 1 - i / row) * row + i % row), top)));
    if (magic != "PF") words.white = top;
    const auto code = [&](std::size_t i) { return static_cast<unsigned char>(rest[i]); };
    if (magic == "P6" && top > 255)
        for (std::size_t i = 0; i + 1 < rest.size(); i += 2)
            words.all.push_back(std::to_string(256 * code(i) + code(i + 1)));
    else if (magic == "P6")
        for (std::size_t i = 0; i < rest.size(); ++i) words.all.push_back(std::to_string(code(i)));
    if (magic == "P3")
        while (in >> word) words.all.push_back(word);
    if (words.all.size() != count || count == 0)
        throw std::runtime_error("a picture of " + words.kind() +
                                 ", which ends early or late (was it written in text mode?)");
    return words;
}

inline Words words_of_radiance(const bmc::EnvironmentMap& map) {
    Words words;
    words.width = static_cast<std::size_t>(map.width), words.height = static_cast<std::size_t>(map.height);
    for (int i = 0; i < map.width * map.height; ++i) {
        const bmc::Colour colour = map.colour(map.index(i % map.width, i / map.width));
        for (const double channel : {colour.x, colour.y, colour.z})
            words.all.push_back(bmc::formatted("%.9g", channel));
    }
    return words;
}

// Throws std::runtime_error with what there is, if it cannot be read.
inline Words words_of(const std::string& bytes) {
    const auto begins = [&](const std::string& with) { return bytes.compare(0, with.size(), with) == 0; };
    std::istringstream in(begins("\xEF\xBB\xBF") ? bytes.substr(3) : bytes);  // without a byte order mark
    if (is_pnm(bytes)) return words_of_picture(bytes);
    if (begins("#?")) return words_of_radiance(bmc::read_radiance_hdr(in));
    if (begins("\xFF\xFE")) throw std::runtime_error("a text in UTF-16, as PowerShell's > writes it");
    if (bytes.find('\0') != bytes.npos)
        throw std::runtime_error("neither a text nor a picture that can be read: P3 or P6 (PPM), PF (PFM), Radiance");
    Words words;
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
    double squares = 0, sum = 0, expected = 0;
    for (const std::size_t pixel : pixels)
        for (std::size_t i = pixel; i < pixel + 3; ++i) {
            const double error = actual.light(i) - reference.light(i);
            squares += error * error;
            sum += error;
            expected += reference.light(i);
        }
    if (!std::isfinite(squares / expected)) return "";
    return bmc::formatted("; there the RMSE is %.3g, the brightness is off by %+.1f %%",
                          std::sqrt(squares / (3 * static_cast<double>(pixels.size()))), 100 * sum / expected);
}

inline bmc::Image image_of(const Words& words) {
    bmc::Image image(static_cast<int>(words.width), static_cast<int>(words.height));
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = {words.light(3 * i), words.light(3 * i + 1), words.light(3 * i + 2)};
    return image;
}

// The errors of a picture of the sphere scene over the pixels that show an object, in words.
inline std::string object_errors(const Words& reference, const Words& actual) {
    const bmc::ImageError error = bmc::image_error(image_of(actual), image_of(reference));
    if (!std::isfinite(error.rmse * error.brightness)) return "no light is reflected by objects";
    return bmc::formatted(
        "over objects the RMSE is %.3g, the brightness is off by %+.1f %%, and neighbours' errors "
        "correlate by %.2f",
        error.rmse, 100 * error.brightness, error.correlation);
}

// In words; empty if nothing differs. With a tolerance (which codes do not have) one pixel in a thousand may differ,
// and white space. Without one all bytes are the same, but for comments in a picture's header. With objects pictures of
// one size are compared by their errors over objects alone, whatever their kinds. Throws std::runtime_error if the
// reference cannot be read.
inline std::string difference(const std::string& reference, const std::string& actual, double tolerance,
                              bool objects = false) {
    if (without_comments(reference) == without_comments(actual)) return "";
    Words expected, found;
    try {
        expected = words_of(without_comments(reference));
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(std::string("the reference: ") + error.what());
    }
    try {
        found = words_of(without_comments(actual));
    } catch (const std::runtime_error& error) {
        return std::string("here: ") + error.what();
    }
    const bool text = !expected.is_picture(), codes = expected.white > 0;
    if (objects && !text && expected.width == found.width && expected.height == found.height)
        return object_errors(expected, found);
    if (objects || expected.kind() != found.kind()) return "reference: " + expected.kind() + ", here: " + found.kind();
    const std::size_t step = text ? 1 : 3, all = std::max(expected.all.size(), found.all.size());
    const auto word = [](const Words& words, std::size_t i) { return i < words.all.size() ? words.all[i] : "nothing"; };
    const auto same = [&](std::size_t i) { return agree(word(expected, i), word(found, i), codes ? 0 : tolerance); };
    std::vector<std::size_t> differing;  // words of a text, or pixels
    for (std::size_t i = 0; i < all; i += step)
        if (!same(i) || (!text && !(same(i + 1) && same(i + 2)))) differing.push_back(i);
    if (differing.size() <= (tolerance > 0 && !text ? all / step / 1000 : 0))
        return tolerance > 0 ? "" : "no word differs, but white space, a byte order mark, or the form of the numbers";
    std::size_t i = differing[0];
    const std::string place =
        text ? bmc::formatted("line %zu", (i < expected.lines.size() ? expected : found).lines[i])
             : bmc::formatted("pixel (x %zu, y %zu)", i / 3 % expected.width, i / 3 / expected.width);
    while (same(i)) ++i;
    return place + ": reference " + word(expected, i) + ", here " + word(found, i) +
           bmc::formatted("; %zu of %zu %s differ", differing.size(), all / step, text ? "words" : "pixels") +
           (text ? "" : errors_of(expected, found, differing));
}
