// An image of linear RGB radiance, and the two formats it is written in.
#pragma once

#include "numerics/vec3.h"

#include <string>
#include <vector>

namespace bmc {
class Image {
public:
    // A black image. width and height are at least 1.
    Image(int width, int height);

    int width() const { return width_; }
    int height() const { return height_; }

    // The pixel in column x of row y; row 0 is the top.
    Color operator()(int x, int y) const { return (*this)[index(x, y)]; }
    void set(int x, int y, Color color) {
        float* rgb = &rgb_[3 * index(x, y)];
        for (const double channel : {color.x, color.y, color.z}) *rgb++ = static_cast<float>(channel);
    }

    // The pixels row after row from the top, and all their channels.
    std::size_t size() const { return rgb_.size() / 3; }
    Color operator[](std::size_t i) const { return {rgb_[3 * i], rgb_[3 * i + 1], rgb_[3 * i + 2]}; }
    const std::vector<float>& rgb() const { return rgb_; }

private:
    std::size_t index(int x, int y) const { return static_cast<std::size_t>(y * width_ + x); }

    int width_, height_;
    std::vector<float> rgb_;
};

// The image whose pixel in column x of row y is pixel(x, y).
template <class Pixel>
Image image_of(int width, int height, Pixel pixel) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.set(x, y, pixel(x, y));
    return image;
}

// The linear value in [0, 1] of a code in [0, 1]: the inverse of the sRGB transfer function (IEC 61966-2-1).
double srgb_decoded(double code);

enum class Format { ppm, pfm };
constexpr std::pair<const char*, Format> format_names[] = {{"ppm", Format::ppm}, {"pfm", Format::pfm}};

// Binary PPM ("P6"), 8 bits per channel, sRGB; values are clamped to [0, 1].
std::string to_ppm(const Image& image);

// PFM ("PF"), 32-bit linear floats, little-endian (the header's -1), bottom row first as the format asks.
std::string to_pfm(const Image& image);
}  // namespace bmc
