// Pictures that other programs wrote: PPM and PFM, as the formats allow them.
#pragma once

#include "scene/image.h"

#include <iosfwd>

namespace bmc {
struct PictureFile {
    Image image;  // linear radiance
    int maxval;   // the largest code of a channel, which stands for 1; 0: the file held linear floats
};

// Reads a picture from a binary stream: PPM, binary (P6) or in words (P3), sRGB with any largest code from 1 to 255; or
// PFM in colour (PF), linear floats of either byte order. Memory follows what the file holds, not what its header
// claims. Throws std::runtime_error, one line: what is wrong and, within the picture, in which row (0 at the top).
PictureFile read_picture(std::istream& in);

// The code in [0, 1] of a linear value, clamped to [0, 1], by the sRGB transfer function; 0 for nan.
double srgb_encoded(double linear);

// What a file with the largest code maxval keeps of an image: clamped, encoded, rounded and read back. Floats (0) keep
// all of it.
Image as_stored(const Image& image, int maxval);

// The image with f of every channel of every pixel.
template <class Function>
Image each_channel(const Image& image, Function f) {
    return image_of(image.width(), image.height(), [&](int x, int y) {
        const Color color = image(x, y);
        return Color{f(color.x), f(color.y), f(color.z)};
    });
}
}  // namespace bmc
