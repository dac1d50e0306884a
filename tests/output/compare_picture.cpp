// Pictures of three channels a pixel: PPM (P6) with codes up to 255, and PFM (PF).
#include "compare.h"

#include "../course/judge/likely_mistakes.h"
#include "scene/image.h"
#include "scene/scene.h"

#include <algorithm>
#include <cstdint>
#include <map>
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

// The linear light of a channel; PPM is coded as IEC 61966-2-1 says.
double light(const Picture& picture, std::size_t i) {
    return picture.floats ? picture.values[i] : bmc::srgb_decoded(picture.values[i] / 255);
}

// The first channels of the pixels that differ, the actual picture mirrored first.
std::vector<std::size_t> differences(const Picture& reference, const Picture& actual, double tolerance,
                                     const bmc::Mirroring& mirroring = {"", false, false}) {
    std::vector<std::size_t> found;
    const std::size_t width = reference.width, height = reference.height;
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t i = 3 * (y * width + x), column = mirroring.left_right ? width - 1 - x : x,
                              j = 3 * ((mirroring.up_down ? height - 1 - y : y) * width + column);
            bool same = true;
            for (std::size_t k = 0; k < 3; ++k)
                same = same && agree(reference.values[i + k], actual.values[j + k], reference.floats ? tolerance : 0);
            if (!same) found.push_back(i);
        }
    return found;
}

bool too_few(const std::vector<std::size_t>& pixels, const Picture& picture, double tolerance) {
    return pixels.size() <= (tolerance > 0 ? picture.width * picture.height / 1000 : 0);
}

std::string describe_first(const Picture& reference, const Picture& actual, const std::vector<std::size_t>& pixels) {
    const char* const colours[] = {"red", "green", "blue"};
    std::size_t i = pixels[0];
    while (reference.values[i] == actual.values[i]) ++i;
    double largest = 0;  // passes over a nan
    for (const std::size_t pixel : pixels)
        for (std::size_t k = pixel; k < pixel + 3; ++k)
            largest = std::fmax(largest, std::fabs(reference.values[k] - actual.values[k]));
    return bmc::formatted("pixel (x %zu, y %zu), %s: reference %.9g, here %.9g; ", i / 3 % reference.width,
                          i / 3 / reference.width, colours[i % 3], reference.values[i], actual.values[i]) +
           count_of(pixels.size(), reference.width * reference.height, "pixels") + ", at most by " +
           in_words(largest, 3);
}

std::string describe_mirroring(const Picture& reference, const Picture& actual, double tolerance) {
    for (const bmc::Mirroring& each : bmc::mirrorings)
        if (too_few(differences(reference, actual, tolerance, each), actual, tolerance))
            return std::string("it is ") + each.name;
    return "";
}

// If it is one part of the sphere scene that differs: which.
std::string describe_part(const std::vector<std::size_t>& pixels, const Picture& picture) {
    if (pixels.size() == picture.width * picture.height) return "";
    const bmc::Scene scene = bmc::sphere_scene();
    const bmc::Camera camera{static_cast<int>(picture.width), static_cast<int>(picture.height)};
    std::map<std::string, std::size_t> parts;
    for (const std::size_t i : pixels) {
        const auto x = static_cast<int>(i / 3 % picture.width), y = static_cast<int>(i / 3 / picture.width);
        const auto hit = intersect(scene, camera.ray(x, y));
        ++parts[!hit ? "in the background" : hit->object == bmc::Object::sphere ? "on the sphere" : "on the rectangle"];
    }
    for (const auto& [name, count] : parts)
        if (static_cast<double>(count) >= 0.99 * static_cast<double>(pixels.size()))
            return "only pixels " + name + " differ";
    return "";
}

// The one factor, neither 0 nor 1, between the lights of all channels that are neither too dark nor too bright for
// their bytes to tell it; 0 if there is none.
double common_factor(const Picture& reference, const Picture& actual, const std::vector<std::size_t>& pixels) {
    const auto tells = [](double light) { return light > 0.02 && light < 0.99; };
    std::vector<double> factors;
    for (const std::size_t pixel : pixels)
        for (std::size_t i = pixel; i < pixel + 3; ++i)
            if (tells(light(reference, i)) && tells(light(actual, i)))
                factors.push_back(light(actual, i) / light(reference, i));
    if (factors.empty() || factors.size() < pixels.size() / 4) return 0;
    std::sort(factors.begin(), factors.end());
    const double middle = factors[factors.size() / 2], low = factors[factors.size() / 50];
    const double high = factors[factors.size() - 1 - factors.size() / 50];
    return low > 0.95 * middle && high < 1.05 * middle && std::fabs(middle - 1) > 0.02 ? middle : 0;
}

// Brightness where the pictures differ.
std::string describe_light(const Picture& reference, const Picture& actual, const std::vector<std::size_t>& pixels) {
    double expected = 0, found = 0;
    for (const std::size_t pixel : pixels)
        for (std::size_t i = pixel; i < pixel + 3; ++i) {
            expected += light(reference, i);
            found += light(actual, i);
        }
    if (!std::isfinite(found / expected)) return "";
    if (found == 0) return "where it differs, it is black";
    const double factor = common_factor(reference, actual, pixels), percent = 100 * std::fabs(found / expected - 1);
    if (factor != 0)
        return "the light of every pixel is " + in_words(factor, 3) + " times the reference's" + reason(factor);
    return "there it is " + in_words(percent, percent < 10 ? 2 : 3) + (found < expected ? " % darker" : " % brighter");
}

}  // namespace

std::string picture_difference(const std::string& reference, const std::string& actual, double tolerance) {
    const std::optional<Picture> expected = parse_picture(reference), found = parse_picture(actual);
    if (!expected) throw std::runtime_error("the reference is a damaged picture (were its line ends converted?)");
    if (!found)
        return bmc::formatted("reference: a picture (%s), here: %zu bytes that are not a complete one",
                              expected->header.c_str(), actual.size());
    if (expected->header != found->header) return "header: reference " + expected->header + ", here " + found->header;
    const std::vector<std::size_t> pixels = differences(*expected, *found, tolerance);
    if (pixels.empty() && tolerance == 0) return "no pixel differs, but white space in the header or the sign of a 0";
    if (too_few(pixels, *found, tolerance)) return "";
    std::string text = describe_first(*expected, *found, pixels);
    const std::string mirroring = describe_mirroring(*expected, *found, tolerance);
    add(text, mirroring);
    if (!mirroring.empty()) return text;
    add(text, describe_part(pixels, *found));
    add(text, describe_light(*expected, *found, pixels));
    return text;
}
