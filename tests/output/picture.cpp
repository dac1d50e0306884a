#include "picture.h"

#include <algorithm>
#include <cstdint>
#include <sstream>

namespace {

// The sign of a PFM's scale says which byte comes first, whatever the order of this machine.
double float_at(const std::string& bytes, std::size_t at, bool little_endian) {
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 4; ++k)
        word = word << 8 | static_cast<unsigned char>(bytes[little_endian ? at + 3 - k : at + k]);
    return static_cast<double>(bmc::portable::bit_cast<float>(word));
}

// The next word of a header, in which comments last until the end of the line.
template <class Word>
bool read_word(std::istream& in, Word& word) {
    while ((in >> std::ws).peek() == '#') in.ignore(1 << 20, '\n');
    return static_cast<bool>(in >> word);
}

}  // namespace

std::optional<Picture> parse_picture(const std::string& bytes) {
    std::istringstream in(bytes);
    std::string magic;
    int width = 0, height = 0;
    double top = 0;  // PPM: the largest code; PFM: the scale
    if (!read_word(in, magic) || !read_word(in, width) || !read_word(in, height) || !read_word(in, top) || in.get() < 0)
        return std::nullopt;
    const bool floats = magic == "PF";
    if ((!floats && magic != "P6") || !(floats ? top != 0 : top == 255)) return std::nullopt;
    if (std::min(width, height) < 1 || std::max(width, height) > 9999) return std::nullopt;
    const std::size_t begin = static_cast<std::size_t>(in.tellg()), size = floats ? 4 : 1;
    if (bytes.size() != begin + 3 * size * static_cast<std::size_t>(width) * static_cast<std::size_t>(height))
        return std::nullopt;
    Picture picture{floats ? bmc::Format::pfm : bmc::Format::ppm, bytes.substr(0, begin - 1), {width, height}};
    std::replace(picture.header.begin(), picture.header.end(), '\n', ' ');
    std::size_t at = begin;
    for (int row = 0; row < height; ++row)
        for (int x = 0; x < width; ++x) {
            bmc::Color& pixel = picture.values(x, floats ? height - 1 - row : row);
            for (double* channel : {&pixel.x, &pixel.y, &pixel.z}) {
                *channel = floats ? float_at(bytes, at, top < 0) : static_cast<unsigned char>(bytes[at]);
                at += size;
            }
        }
    return picture;
}

bmc::Image linear_light(const Picture& picture) {
    bmc::Image light = picture.values;
    if (picture.format == bmc::Format::pfm) return light;
    for (bmc::Color& c : light.pixels)
        c = {bmc::srgb_to_linear(c.x / 255), bmc::srgb_to_linear(c.y / 255), bmc::srgb_to_linear(c.z / 255)};
    return light;
}
