// What differs between two pictures, pixel by pixel.
#include "compare.h"
#include "picture.h"

#include <stdexcept>

namespace {

constexpr const char* colours[] = {"red", "green", "blue"};
constexpr double bmc::Colour::*channels[] = {&bmc::Colour::x, &bmc::Colour::y, &bmc::Colour::z};

// The pixels that differ.
std::vector<std::size_t> differences(const Picture& reference, const Picture& actual, double tolerance) {
    if (!bmc::is_linear(reference.format)) tolerance = 0;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < reference.values.pixels.size(); ++i) {
        const bmc::Colour a = reference.values.pixels[i], b = actual.values.pixels[i];
        if (!agree(a.x, b.x, tolerance) || !agree(a.y, b.y, tolerance) || !agree(a.z, b.z, tolerance))
            found.push_back(i);
    }
    return found;
}

std::string describe_first(const bmc::Image& reference, const bmc::Image& actual,
                           const std::vector<std::size_t>& pixels) {
    const bmc::Colour expected = reference.pixels[pixels[0]], here = actual.pixels[pixels[0]];
    std::size_t k = 0;
    while (expected.*channels[k] == here.*channels[k]) ++k;
    double largest = 0;  // passes over a nan
    for (const std::size_t pixel : pixels)
        for (const auto channel : channels)
            largest = std::fmax(largest, std::fabs(reference.pixels[pixel].*channel - actual.pixels[pixel].*channel));
    const std::size_t width = static_cast<std::size_t>(reference.width);
    return bmc::formatted("pixel (x %zu, y %zu), %s: reference %.9g, here %.9g; ", pixels[0] % width, pixels[0] / width,
                          colours[k], expected.*channels[k], here.*channels[k]) +
           count_of(pixels.size(), reference.pixels.size(), "pixels") + bmc::formatted(", at most by %.3g", largest);
}

// Of the pixels that differ: how large the errors of the linear light are, and their mean over that of the reference.
std::string describe_errors(const bmc::Image& reference, const bmc::Image& actual,
                            const std::vector<std::size_t>& pixels) {
    const bmc::Colour one{1, 1, 1};
    double squares = 0, sum = 0, expected = 0;
    for (const std::size_t pixel : pixels) {
        const bmc::Colour error = actual.pixels[pixel] - reference.pixels[pixel];
        squares += dot(error, error);
        sum += dot(error, one);
        expected += dot(reference.pixels[pixel], one);
    }
    if (!std::isfinite(squares / expected)) return "";
    return bmc::formatted("; there the RMSE is %.3g, the brightness is off by %+.1f %%",
                          std::sqrt(squares / (3 * static_cast<double>(pixels.size()))), 100 * sum / expected);
}

}  // namespace

std::string picture_difference(const std::string& reference, const std::string& actual, double tolerance) {
    Picture expected{bmc::Format::ppm, "", {1, 1}}, found = expected;
    try {
        expected = parse_picture(reference);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(std::string("the reference is damaged: ") + error.what());
    }
    try {
        found = parse_picture(actual);
    } catch (const std::runtime_error& error) {
        return "reference: a picture (" + expected.header + "), here: no complete one: " + error.what();
    }
    if (expected.header != found.header) return "header: reference " + expected.header + ", here " + found.header;
    const bmc::Image expected_light = linear_light(expected), light = linear_light(found);
    const std::vector<std::size_t> pixels = differences(expected, found, tolerance);
    if (pixels.empty() && tolerance == 0)
        return "no pixel differs, but the form of the file: white space, text for bytes, or the sign of a 0";
    if (pixels.size() <= (tolerance > 0 ? light.pixels.size() / 1000 : 0)) return "";
    return describe_first(expected.values, found.values, pixels) + describe_errors(expected_light, light, pixels);
}
