#include "scene/image.h"

#include "numerics/formatted.h"

#include <array>
#include <cstdint>
#include <stdexcept>

namespace bmc {
namespace {

// The bytes of linear values. Byte k begins at threshold k, where the transfer function is (k - 1/2) / 255. It is
// nowhere steeper than 12.92, so a step of 1 / 4096 holds at most one threshold: the byte where the step begins and one
// comparison decide.
class SrgbEncoder {
public:
    SrgbEncoder() {
        for (std::size_t k = 1; k < 256; ++k) thresholds_[k] = srgb_decoded((static_cast<double>(k) - 0.5) / 255);
        thresholds_[256] = 2;  // for the byte 255: above all values
        std::size_t byte = 0;
        for (std::size_t step = 0; step <= steps; ++step) {
            while (thresholds_[byte + 1] <= static_cast<double>(step) / steps) ++byte;
            first_[step] = static_cast<unsigned char>(byte);
        }
    }

    char byte(double linear) const {
        const double v = linear > 0 ? (linear < 1 ? linear : 1) : 0;  // 0 for nan, too
        const std::size_t first = first_[static_cast<std::size_t>(v * steps)];
        return static_cast<char>(static_cast<unsigned char>(first + (v >= thresholds_[first + 1])));
    }

private:
    static constexpr std::size_t steps = 4096;
    std::array<double, 257> thresholds_{};
    std::array<unsigned char, steps + 1> first_{};
};

std::string to_ppm(const Image& image) {
    const SrgbEncoder encoder;
    std::string bytes = formatted("P6\n%d %d\n255\n", image.width, image.height);
    bytes.reserve(bytes.size() + 3 * image.pixels.size());
    for (const Color& pixel : image.pixels)
        for (const double channel : {pixel.x, pixel.y, pixel.z}) bytes += encoder.byte(channel);
    return bytes;
}

std::string to_pfm(const Image& image) {
    std::string bytes = formatted("PF\n%d %d\n-1.0\n", image.width, image.height);
    for (int y = image.height; y-- > 0;)
        for (int x = 0; x < image.width; ++x)
            for (const double channel : {image(x, y).x, image(x, y).y, image(x, y).z}) {
                const auto bits = portable::bit_cast<std::uint32_t>(static_cast<float>(channel));
                for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(bits >> shift & 0xff);
            }
    return bytes;
}

}  // namespace

double srgb_decoded(double code) { return code <= 0.04045 ? code / 12.92 : portable::pow((code + 0.055) / 1.055, 2.4); }

std::string to_file(const Image& image, Format format) {
    switch (format) {
        case Format::ppm: return to_ppm(image);
        case Format::pfm: return to_pfm(image);
    }
    throw std::logic_error("a format without a file");
}
}  // namespace bmc
