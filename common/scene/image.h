// An image of linear RGB radiance, and the formats it is written in.
#pragma once

#include "base/vec3.h"

#include <string>
#include <vector>

namespace bmc {
struct Image {
    int width, height;           // at least 1
    std::vector<Colour> pixels;  // row after row, the top one first

    // A black image.
    Image(int columns, int rows)
        : width(columns), height(rows), pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

    // The pixel in column x of row y.
    Colour& operator()(int x, int y) { return pixels[static_cast<std::size_t>(y * width + x)]; }
    Colour operator()(int x, int y) const { return pixels[static_cast<std::size_t>(y * width + x)]; }
};

// The linear value in [0, 1] of a code in [0, 1]: the inverse of the sRGB transfer function (IEC 61966-2-1).
double srgb_to_linear(double code);

enum class Format { ppm, pfm, bmp };
inline constexpr const char* format_names[] = {"ppm", "pfm", "bmp"};

// The image as a file.
// - ppm: binary PPM ("P6"), 8 bits per channel, sRGB; values are clamped to [0, 1].
// - bmp: the same codes as BMP, which every system opens.
// - pfm: PFM ("PF"), 32-bit linear floats, little-endian (the header's -1), bottom row first as the format asks.
std::string encode(const Image& image, Format format);
}  // namespace bmc
