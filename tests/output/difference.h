// What differs between an output and its reference: the words of a text, or the numbers of a picture, a PPM (P3, P6), a
// PFM (PF) or a Radiance picture.
#pragma once

#include "command_line/command_line.h"
#include "experiments/picture_cost.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

struct Content {
    std::string text;                   // unless it is a picture
    std::size_t width = 0, height = 0;  // of a picture
    double white = 0;                   // its largest code; 0 for floats
    std::vector<float> numbers;         // three for each pixel, row after row, the top one first

    std::string kind() const {
        const std::string numbers_are = white > 0 ? bmc::formatted("codes up to %g", white) : "floats";
        return width > 0 ? bmc::formatted("%zu x %zu, ", width, height) + numbers_are : "no picture";
    }
    double light(std::size_t i) const {  // linear
        return white > 0 ? bmc::srgb_to_linear(static_cast<double>(numbers[i]) / white) : numbers[i];
    }
};

// The word of a PPM or PFM that begins at this place or later; empty at the end. The place is then behind it. A
// comment, from # to the end of a line, ends a word as white space does.
inline std::string next_word(const std::string& bytes, std::size_t& at) {
    std::string word;
    for (; at < bytes.size(); ++at) {
        if (bytes[at] == '#') at = std::min(bytes.find('\n', at), bytes.size());
        if (at == bytes.size()) break;
        if (std::isspace(static_cast<unsigned char>(bytes[at])) == 0)
            word += bytes[at];
        else if (!word.empty())
            break;
    }
    return word;
}

inline double number_of(const std::string& word, const std::string& name, double low, double high) {
    try {
        return bmc::parse_real(word.substr(0, 20), low, high);
    } catch (const std::invalid_argument& error) {
        throw std::runtime_error("the " + name + " " + error.what());
    }
}

// Of a PPM or a PFM. Codes have one byte, or two if 255 is not the largest; floats have four, the last one first if the
// scale is negative, whatever this machine does, and begin with the bottom row.
inline Content picture_of(const std::string& bytes) {
    Content picture;
    std::size_t at = 2;
    const bool floats = bytes[1] == 'F', plain = bytes[1] == '3';
    picture.width = static_cast<std::size_t>(number_of(next_word(bytes, at), "width", 1, 65535));
    picture.height = static_cast<std::size_t>(number_of(next_word(bytes, at), "height", 1, 65535));
    const double top = number_of(next_word(bytes, at), floats ? "scale" : "largest code", floats ? -1e9 : 1, 65535);
    if (!floats) picture.white = top;
    const std::size_t row = 3 * picture.width, count = row * picture.height;
    const std::size_t size = floats ? 4 : top > 255 ? 2 : 1, begin = at + 1, end = begin + size * count;
    if (plain)
        for (std::string word; !(word = next_word(bytes, at)).empty();)
            picture.numbers.push_back(static_cast<float>(number_of(word, "code", 0, top)));
    else if (bytes.size() == end)
        picture.numbers.resize(count);
    if (picture.numbers.size() != count)
        throw std::runtime_error("a picture of " + picture.kind() + ", " +
                                 (bytes.compare(std::min(end, bytes.size()), 2, bytes, 0, 2) == 0
                                      ? "and another one behind it"
                                      : "which ends early or late (was it written in text mode?)"));
    for (std::size_t i = 0; i < count && !plain; ++i) {
        const std::size_t from = begin + size * (floats ? (picture.height - 1 - i / row) * row + i % row : i);
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < size; ++k)
            word = word << 8 | static_cast<unsigned char>(bytes[from + (top < 0 ? size - 1 - k : k)]);
        picture.numbers[i] = floats ? static_cast<float>(std::fabs(top)) * bmc::portable::bit_cast<float>(word)
                                    : static_cast<float>(word);
    }
    return picture;
}

inline Content radiance_of(const std::string& bytes) {
    std::istringstream in(bytes);
    const bmc::EnvironmentMap map = bmc::read_radiance_hdr(in);
    Content picture;
    picture.width = static_cast<std::size_t>(map.width), picture.height = static_cast<std::size_t>(map.height);
    for (int i = 1; i <= map.width * map.height; ++i)
        for (const double channel : {map.colour(i).x, map.colour(i).y, map.colour(i).z})
            picture.numbers.push_back(static_cast<float>(channel));
    return picture;
}

// Throws std::runtime_error with what there is, if it cannot be read.
inline Content content_of(std::string bytes) {
    const auto begins = [&](const char* with) { return bytes.compare(0, std::strlen(with), with) == 0; };
    if (begins("P3") || begins("P6") || begins("PF")) return picture_of(bytes);
    if (begins("#?")) return radiance_of(bytes);
    if (begins("\xFF\xFE")) throw std::runtime_error("a text in UTF-16, as PowerShell's > writes it");
    if (bytes.find('\0') != bytes.npos)
        throw std::runtime_error("neither a text nor a picture that can be read: P3 or P6 (PPM), PF (PFM), Radiance");
    Content text;
    text.text = std::move(bytes);
    return text;
}

// Whether a number may stand in the place of the reference's: within the relative tolerance plus 1e-9 if there is one.
// What is not a number has no sign.
inline bool agree(double reference, double actual, double tolerance) {
    if (std::isnan(reference)) return std::isnan(actual);
    if (tolerance == 0 || std::isinf(reference)) return reference == actual;
    return std::fabs(reference - actual) <= tolerance * std::fabs(reference) + 1e-9;
}

// The same of words: with a tolerance numbers, with the same behind them ("0.5;").
inline bool agree(const std::string& reference, const std::string& actual, double tolerance) {
    if (reference == actual || tolerance == 0) return reference == actual;
    char *end_a = nullptr, *end_b = nullptr;
    const double a = std::strtod(reference.c_str(), &end_a), b = std::strtod(actual.c_str(), &end_b);
    return end_a != reference.c_str() && end_b != actual.c_str() && std::string(end_a) == end_b &&
           agree(a, b, tolerance);
}

struct Word {
    std::string text = "nothing";
    std::size_t line = 0;
};

inline std::vector<Word> words_of(const std::string& text) {
    std::istringstream in(text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? text.substr(3) : text);  // a byte order mark
    std::vector<Word> words;
    std::size_t number = 1;
    for (std::string line, word; std::getline(in, line); ++number)
        for (std::istringstream columns(line); columns >> word;) words.push_back({word, number});
    return words;
}

inline std::string text_difference(const std::string& reference, const std::string& actual, double tolerance) {
    if (reference == actual) return "";
    std::vector<Word> expected = words_of(reference), found = words_of(actual);
    const std::size_t all = std::max(expected.size(), found.size());
    expected.resize(all), found.resize(all);
    std::vector<std::size_t> differing;
    for (std::size_t i = 0; i < all; ++i)
        if (!agree(expected[i].text, found[i].text, tolerance)) differing.push_back(i);
    if (differing.empty()) return tolerance > 0 ? "" : "no word differs, but white space or a byte order mark";
    const Word &a = expected[differing[0]], &b = found[differing[0]];
    return bmc::formatted("line %zu: reference %s, here %s; %zu of %zu words differ", std::max(a.line, b.line),
                          a.text.c_str(), b.text.c_str(), differing.size(), all);
}

// With the error of the linear light of the pixels that differ, and of its mean. Codes have no tolerance.
inline std::string picture_difference(const Content& reference, const Content& actual, double tolerance) {
    const auto same = [&](std::size_t i) {
        return agree(reference.numbers[i], actual.numbers[i], reference.white > 0 ? 0 : tolerance);
    };
    const std::size_t all = reference.width * reference.height;
    std::size_t first = 0, differing = 0;  // the first number; pixels
    double squares = 0, sum = 0, expected = 0;
    for (std::size_t pixel = 0; pixel < 3 * all; pixel += 3) {
        if (same(pixel) && same(pixel + 1) && same(pixel + 2)) continue;
        if (differing++ == 0)
            for (first = pixel; same(first);) ++first;
        for (std::size_t i = pixel; i < pixel + 3; ++i) {
            const double light = reference.light(i), error = actual.light(i) - light;
            squares += error * error;
            sum += error;
            expected += light;
        }
    }
    if (differing <= (tolerance > 0 ? all / 1000 : 0)) return "";
    const std::string text = bmc::formatted("pixel (x %zu, y %zu): reference %.9g, here %.9g; %zu of %zu pixels differ",
                                            first / 3 % reference.width, first / 3 / reference.width,
                                            reference.numbers[first], actual.numbers[first], differing, all);
    if (!std::isfinite(squares / expected)) return text;
    return text + bmc::formatted("; there the RMSE is %.3g, the brightness is off by %+.1f %%",
                                 std::sqrt(squares / (3 * static_cast<double>(differing))), 100 * sum / expected);
}

inline bmc::Image image_of(const Content& picture) {
    bmc::Image image(static_cast<int>(picture.width), static_cast<int>(picture.height));
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = {picture.light(3 * i), picture.light(3 * i + 1), picture.light(3 * i + 2)};
    return image;
}

// The errors of a picture of the sphere scene over the pixels that show an object, in words. Pixels that are no number
// in one of both are told and left out: they become black in both, and the mean square is over the others.
inline std::string object_errors(const Content& reference, const Content& actual) {
    bmc::Image truth = image_of(reference), image = image_of(actual);
    double objects = 0, lost = 0;
    std::string first;
    bmc::for_each_hit({image.width, image.height}, [&](int x, int y, const bmc::Hit&) {
        ++objects;
        if (std::isfinite(bmc::luminance(image(x, y) - truth(x, y)))) return;
        image(x, y) = truth(x, y) = {};
        if (lost++ == 0) first = bmc::formatted("(x %d, y %d)", x, y);
    });
    const bmc::ImageError error = bmc::image_error(image, truth);
    const bool lit = std::isfinite(error.rmse * error.bias);
    std::string text = "no light is reflected by objects";
    if (lit)
        text = bmc::formatted("over objects the RMSE is %.3g, the brightness is off by %+.1f %%",
                              error.rmse * std::sqrt(objects / (objects - lost)), 100 * error.bias);
    if (lost > 0)
        return text + bmc::formatted(", without %g of %g pixels that are no numbers, the first ", lost, objects) +
               first;
    return lit ? text + bmc::formatted(", and neighbours' errors correlate by %.2f", error.correlation) : text;
}

// In words; empty if nothing differs: of texts no byte, of pictures no number. With a tolerance (which codes do not
// have) one pixel in a thousand may differ, and white space. With objects pictures of one size are compared by their
// errors over objects alone, whatever their kinds. Throws std::runtime_error if the reference cannot be read.
inline std::string difference(std::string reference, std::string actual, double tolerance, bool objects = false) {
    Content expected, found;
    bool here = false;
    try {
        expected = content_of(std::move(reference));
        here = true;
        found = content_of(std::move(actual));
    } catch (const std::runtime_error& error) {
        if (here) return std::string("here: ") + error.what();
        throw std::runtime_error(std::string("the reference: ") + error.what());
    }
    if (objects && expected.width > 0 && expected.width == found.width && expected.height == found.height)
        return object_errors(expected, found);
    if (objects || expected.kind() != found.kind()) return "reference: " + expected.kind() + ", here: " + found.kind();
    return expected.width > 0 ? picture_difference(expected, found, tolerance)
                              : text_difference(expected.text, found.text, tolerance);
}
