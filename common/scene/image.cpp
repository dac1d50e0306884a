#include "scene/image.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace {

std::string header(const char* magic, const Image& image, const char* scale) {
    return std::string(magic) + '\n' + std::to_string(image.width()) + ' ' + std::to_string(image.height()) + '\n' +
           scale + '\n';
}

char srgb_byte(double linear) {
    if (!(linear > 0)) return 0;
    const double v = std::min(linear, 1.0);
    const double encoded = v <= 0.0031308 ? 12.92 * v : 1.055 * portable::pow(v, 1 / 2.4) - 0.055;
    return static_cast<char>(static_cast<unsigned char>(255 * encoded + 0.5));
}

void append_little_endian(std::string& bytes, float value) {
    std::uint32_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(static_cast<unsigned char>(bits >> shift));
}

}  // namespace

Image::Image(int width, int height)
    : width_(width), height_(height), rgb_(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

std::size_t Image::offset(int x, int y) const {
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
}

Color Image::operator()(int x, int y) const {
    const float* rgb = rgb_.data() + offset(x, y);
    return {rgb[0], rgb[1], rgb[2]};
}

void Image::set(int x, int y, Color color) {
    float* rgb = rgb_.data() + offset(x, y);
    rgb[0] = static_cast<float>(color.x);
    rgb[1] = static_cast<float>(color.y);
    rgb[2] = static_cast<float>(color.z);
}

std::string to_ppm(const Image& image) {
    std::string bytes = header("P6", image, "255");
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const Color color = image(x, y);
            for (double channel : {color.x, color.y, color.z}) bytes += srgb_byte(channel);
        }
    return bytes;
}

std::string to_pfm(const Image& image) {
    std::string bytes = header("PF", image, "-1.0");
    for (int y = image.height(); y-- > 0;)
        for (int x = 0; x < image.width(); ++x) {
            const Color color = image(x, y);
            for (double channel : {color.x, color.y, color.z}) append_little_endian(bytes, static_cast<float>(channel));
        }
    return bytes;
}
