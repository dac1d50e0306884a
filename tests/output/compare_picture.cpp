// Pictures of three channels a pixel: PPM (P6) with codes up to 255, and PFM (PF).
#include "compare.h"

#include "scene/image.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace {

struct Picture {
    bool floats;
    std::size_t width, height;
    std::string header;          // in one line
    std::vector<double> values;  // codes or floats, from the top
};

// The sign of a PFM's scale says which byte comes first, whatever the order of this machine.
double float_at(const std::string& bytes, std::size_t at, bool little_endian) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
        word = word << 8 | static_cast<unsigned char>(bytes[little_endian ? at + 3 - k : at + k]);
    return static_cast<double>(bmc::portable::bit_cast<float>(word));
}

std::optional<Picture> parse_picture(const std::string& bytes) {
    std::istringstream in(bytes);
    std::string magic;
    std::size_t width = 0, height = 0;
    double top = 0;  // PPM: the largest code; PFM: the scale
    if (!(in >> magic >> width >> height >> top) || std::max(width, height) > 9999 || in.get() < 0) return std::nullopt;
    const bool floats = magic == "PF";
    if ((!floats && magic != "P6") || !(floats ? top != 0 : top == 255)) return std::nullopt;
    const std::size_t begin = static_cast<std::size_t>(in.tellg()), size = floats ? 4 : 1, row = 3 * width;
    if (bytes.size() != begin + size * row * height) return std::nullopt;
    Picture picture{floats, width, height, bytes.substr(0, begin - 1), {}};
    std::replace(picture.header.begin(), picture.header.end(), '\n', ' ');
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t i = 0; i < row; ++i) {
            const std::size_t at = begin + size * ((floats ? height - 1 - y : y) * row + i);
            picture.values.push_back(floats ? float_at(bytes, at, top < 0) : static_cast<unsigned char>(bytes[at]));
        }
    return picture;
}

bmc::Color color(const Picture& picture, std::size_t pixel) {
    return {picture.values[3 * pixel], picture.values[3 * pixel + 1], picture.values[3 * pixel + 2]};
}

// The linear light of a pixel; PPM is coded as IEC 61966-2-1 says.
bmc::Color light(const Picture& picture, std::size_t pixel) {
    const bmc::Color c = color(picture, pixel);
    if (picture.floats) return c;
    return {bmc::srgb_decoded(c.x / 255), bmc::srgb_decoded(c.y / 255), bmc::srgb_decoded(c.z / 255)};
}

// The pixels that differ.
std::vector<std::size_t> differences(const Picture& reference, const Picture& actual, double tolerance) {
    if (!reference.floats) tolerance = 0;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < reference.width * reference.height; ++i) {
        const bmc::Color a = color(reference, i), b = color(actual, i);
        if (!agree(a.x, b.x, tolerance) || !agree(a.y, b.y, tolerance) || !agree(a.z, b.z, tolerance))
            found.push_back(i);
    }
    return found;
}

std::string describe_first(const Picture& reference, const Picture& actual, const std::vector<std::size_t>& pixels) {
    const char* const colours[] = {"red", "green", "blue"};
    std::size_t i = 3 * pixels[0];
    while (reference.values[i] == actual.values[i]) ++i;
    double largest = 0;  // passes over a nan
    for (const std::size_t pixel : pixels)
        for (std::size_t k = 3 * pixel; k < 3 * pixel + 3; ++k)
            largest = std::fmax(largest, std::fabs(reference.values[k] - actual.values[k]));
    return bmc::formatted("pixel (x %zu, y %zu), %s: reference %.9g, here %.9g; ", i / 3 % reference.width,
                          i / 3 / reference.width, colours[i % 3], reference.values[i], actual.values[i]) +
           count_of(pixels.size(), reference.width * reference.height, "pixels") +
           bmc::formatted(", at most by %.3g", largest);
}

// Of the pixels that differ: how large the errors of the linear light are, their mean over that of the reference, and
// the correlation of those of horizontal neighbours, less the mean.
std::string describe_errors(const Picture& reference, const Picture& actual, const std::vector<std::size_t>& pixels) {
    const auto error = [&](std::size_t pixel) { return light(actual, pixel) - light(reference, pixel); };
    const double count = static_cast<double>(pixels.size());
    const bmc::Color one{1, 1, 1};
    double squares = 0, expected = 0, products = 0, pair_squares = 0;
    bmc::Color sum;
    for (const std::size_t pixel : pixels) {
        squares += dot(error(pixel), error(pixel));
        sum += error(pixel);
        expected += dot(light(reference, pixel), one);
    }
    for (std::size_t i = 0; i + 1 < pixels.size(); ++i) {
        if (pixels[i + 1] != pixels[i] + 1 || pixels[i + 1] % reference.width == 0) continue;
        const bmc::Color here = error(pixels[i]) - 1 / count * sum, next = error(pixels[i + 1]) - 1 / count * sum;
        products += dot(here, next);
        pair_squares += (dot(here, here) + dot(next, next)) / 2;
    }
    if (!std::isfinite(squares / expected)) return "";
    const std::string text = bmc::formatted("; there the RMSE is %.3g, the brightness is off by %+.1f %%",
                                            std::sqrt(squares / (3 * count)), 100 * dot(sum, one) / expected);
    if (pair_squares == 0) return text;
    return text + bmc::formatted(", the correlation of neighbouring errors is %.2f",
                                 std::floor(100 * products / pair_squares + 0.5) / 100);
}

// Errors as a PPM: grey is none, white or black one of 0.1.
std::string picture_of_errors(const Picture& reference, const Picture& actual) {
    std::string bytes = bmc::formatted("P6\n%zu %zu\n255\n", actual.width, actual.height);
    for (std::size_t i = 0; i < actual.width * actual.height; ++i) {
        const bmc::Color error = light(actual, i) - light(reference, i);
        for (const double each : {error.x, error.y, error.z})
            bytes +=
                static_cast<char>(static_cast<unsigned char>(128.5 + 127 * std::fmax(-1, std::fmin(1, 10 * each))));
    }
    return bytes;
}

}  // namespace

std::string picture_difference(const std::string& reference, const std::string& actual, double tolerance,
                               std::string& errors) {
    const std::optional<Picture> expected = parse_picture(reference), found = parse_picture(actual);
    if (!expected) throw std::runtime_error("the reference is a damaged picture (were its line ends converted?)");
    if (!found)
        return bmc::formatted("reference: a picture (%s), here: %zu bytes that are not a complete one",
                              expected->header.c_str(), actual.size());
    if (expected->header != found->header) return "header: reference " + expected->header + ", here " + found->header;
    errors = picture_of_errors(*expected, *found);
    const std::vector<std::size_t> pixels = differences(*expected, *found, tolerance);
    if (pixels.empty() && tolerance == 0) return "no pixel differs, but white space in the header or the sign of a 0";
    if (pixels.size() <= (tolerance > 0 ? found->width * found->height / 1000 : 0)) return "";
    return describe_first(*expected, *found, pixels) + describe_errors(*expected, *found, pixels);
}
