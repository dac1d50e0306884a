#include "scene/image.h"

#include "base/formatted.h"

#include <algorithm>
#include <stdexcept>

namespace bmc {
// Byte k begins where the transfer function is (k - 1/2) / 255. The function is nowhere steeper than 12.92, so a step
// of 1 / 4096 holds at most one such threshold: the byte where the step begins and one comparison decide.
static std::string srgb_codes(const Image& image) {
    std::vector<double> thresholds;  // of the bytes 1 to 255, and a last one above all values
    for (int k = 1; k < 256; ++k) thresholds.push_back(srgb_to_linear((k - 0.5) / 255));
    thresholds.push_back(2);
    std::vector<unsigned char> first;  // the byte of step / 4096
    for (int step = 0; step <= 4096; ++step)
        first.push_back(static_cast<unsigned char>(
            std::upper_bound(thresholds.begin(), thresholds.end(), step / 4096.0) - thresholds.begin()));
    std::string bytes;
    bytes.reserve(3 * image.pixels.size());
    for (const Colour& pixel : image.pixels)
        for (const double channel : {pixel.x, pixel.y, pixel.z}) {
            const double linear = channel > 0 ? (channel < 1 ? channel : 1) : 0;
            const unsigned char byte = first[static_cast<std::size_t>(4096 * linear)];
            bytes += static_cast<char>(byte + (linear >= thresholds[byte]));
        }
    return bytes;
}

static std::string little_endian(std::uint32_t word) {
    std::string bytes;
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(word >> shift & 0xff);
    return bytes;
}

// 54 bytes of header; then rows of blue, green and red, the bottom row first, padded to a multiple of four bytes.
static std::string to_bmp(const Image& image) {
    const std::string codes = srgb_codes(image);
    const std::size_t width = 3 * static_cast<std::size_t>(image.width), padding = (4 - width % 4) % 4;
    const auto size = static_cast<int>((width + padding) * static_cast<std::size_t>(image.height));
    std::string bytes = "BM";
    for (const int word : {54 + size, 0, 54, 40, image.width, image.height, 1 + (24 << 16), 0, size, 3780, 3780, 0, 0})
        bytes += little_endian(static_cast<std::uint32_t>(word));
    for (std::size_t row = codes.size(); row > 0; bytes.append(padding, '\0')) {
        row -= width;
        for (std::size_t i = 0; i < width; ++i) bytes += codes[row + i / 3 * 3 + 2 - i % 3];
    }
    return bytes;
}

static std::string to_pfm(const Image& image) {
    std::string bytes = formatted("PF\n%d %d\n-1.0\n", image.width, image.height);
    for (int y = image.height; y-- > 0;)
        for (int x = 0; x < image.width; ++x)
            for (const double channel : {image(x, y).x, image(x, y).y, image(x, y).z})
                bytes += little_endian(portable::bit_cast<std::uint32_t>(static_cast<float>(channel)));
    return bytes;
}

double srgb_to_linear(double code) {
    return code <= 0.04045 ? code / 12.92 : portable::pow((code + 0.055) / 1.055, 2.4);
}

std::string encode(const Image& image, Format format) {
    switch (format) {
        case Format::pfm: return to_pfm(image);
        case Format::bmp: return to_bmp(image);
        case Format::ppm: return formatted("P6\n%d %d\n255\n", image.width, image.height) + srgb_codes(image);
    }
    throw std::logic_error("encode has no case for this format");
}
}  // namespace bmc
