#include "picture.h"

#include "base/formatted.h"
#include "light/load_environment.h"

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <stdexcept>

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

// Throws if there are more or fewer bytes than the header announces, which ends at `begin`. In text mode it has a CR
// before its LF.
void require_size(const std::string& bytes, std::size_t begin, std::size_t expected) {
    if (bytes.size() == expected || (bytes.size() == expected + 1 && bytes.back() == '\n')) return;
    const std::size_t size = bytes.size();
    std::string text = size < expected ? bmc::formatted("bytes that are missing at the end: %zu", expected - size)
                                       : bmc::formatted("bytes behind the last pixel: %zu", size - expected);
    if (bytes.find("\r\n") <= begin)
        text += "; it was written in text mode, with CR before LF: open the file in binary mode";
    throw std::runtime_error(text);
}

Picture radiance_picture(const std::string& bytes) {
    std::istringstream in(bytes);
    const bmc::EnvironmentMap map = bmc::read_radiance_hdr(in);
    Picture picture{bmc::Format::pfm, bmc::formatted(".hdr %d %d", map.width, map.height), {map.width, map.height}};
    for (std::size_t i = 0; i < picture.values.pixels.size(); ++i)
        picture.values.pixels[i] = map.colour(1 + static_cast<int>(i));
    return picture;
}

}  // namespace

Picture parse_picture(const std::string& bytes) {
    if (bytes.compare(0, 2, "#?") == 0) return radiance_picture(bytes);
    std::istringstream in(bytes);
    std::string magic;
    int width = 0, height = 0;
    double top = 0;  // PPM: the largest code; PFM: its size is a factor of all values
    const bool header = read_word(in, magic) && read_word(in, width) && read_word(in, height) && read_word(in, top);
    if (magic.compare(0, 2, "\xff\xfe") == 0)
        throw std::runtime_error("it is UTF-16, as PowerShell's > writes it; cmd /c \"PROGRAM > FILE\" does not");
    if (magic != "P3" && magic != "P6" && magic != "PF")
        throw std::runtime_error("it begins with none of P6, P3, PF and #?; a PPM, PFM or .hdr file does");
    const bool floats = magic == "PF", text = magic == "P3";
    if (!header || in.get() < 0) throw std::runtime_error("it ends inside the header");
    if (!(floats ? std::isfinite(top) && top != 0 : top == 255))
        throw std::runtime_error(bmc::formatted("its largest code is %g; only 255 is supported", top));
    if (std::min(width, height) < 1 || std::max(width, height) > 9999)
        throw std::runtime_error(bmc::formatted("its size %d x %d is not from 1 x 1 to 9999 x 9999", width, height));
    const std::size_t begin = static_cast<std::size_t>(in.tellg()), size = floats ? 4 : 1;
    const std::size_t count = 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    if (!text) require_size(bytes, begin, begin + size * count);
    if (text && bytes.size() < begin + 2 * count - 1) throw std::runtime_error("it ends before the last pixel");
    Picture picture{floats ? bmc::Format::pfm : bmc::Format::ppm, bytes.substr(0, begin - 1), {width, height}};
    std::replace(picture.header.begin(), picture.header.end(), '\n', ' ');
    if (text) picture.header[1] = '6';
    std::size_t at = begin;
    for (int row = 0; row < height; ++row)
        for (int x = 0; x < width; ++x) {
            bmc::Colour& pixel = picture.values(x, floats ? height - 1 - row : row);
            for (double* channel : {&pixel.x, &pixel.y, &pixel.z}) {
                if (floats)
                    *channel = std::fabs(top) * float_at(bytes, at, top < 0);
                else if (!text)
                    *channel = static_cast<unsigned char>(bytes[at]);
                else if (!(read_word(in, *channel) && *channel >= 0 && *channel <= 255))
                    throw std::runtime_error(bmc::formatted("row %d, column %d: no code from 0 to 255", row, x));
                at += size;
            }
        }
    return picture;
}

bmc::Image linear_light(const Picture& picture) {
    bmc::Image light = picture.values;
    if (bmc::is_linear(picture.format)) return light;
    for (bmc::Colour& c : light.pixels)
        c = {bmc::srgb_to_linear(c.x / 255), bmc::srgb_to_linear(c.y / 255), bmc::srgb_to_linear(c.z / 255)};
    return light;
}
