#include "light/radiance_hdr.h"

#include <array>
#include <cstdio>
#include <istream>
#include <stdexcept>

namespace bmc {
namespace {

using Rgbe = std::array<unsigned char, 4>;

std::string header_line(std::istream& in) {
    char line[4096];
    if (!in.getline(line, sizeof line))
        throw std::runtime_error(in.eof() ? "the file ends inside the header" : "a line of the header is too long");
    std::string text = line;
    if (!text.empty() && text.back() == '\r') text.pop_back();
    return text;
}

struct Header {
    int width, height;
    double exposure = 1;  // the radiances of the file are so many times the true ones
};

double exposure_of(const std::string& line) {
    double exposure = 0;
    char more;
    if (std::sscanf(line.c_str(), "EXPOSURE=%lf %c", &exposure, &more) == 1 && exposure >= 1e-6 && exposure <= 1e6)
        return exposure;
    throw std::runtime_error("'" + line + "' is no exposure from 1e-6 to 1e6");
}

Header read_header(std::istream& in) {
    in.exceptions(std::ios::badbit);  // an error of reading does not end the file
    const std::string program = header_line(in);
    if (program != "#?RADIANCE" && program != "#?RGBE")
        throw std::runtime_error("not a Radiance picture: its first line should be #?RADIANCE or #?RGBE");
    Header header{};
    int lines = 0;
    for (std::string line = header_line(in); !line.empty(); line = header_line(in)) {
        if (++lines > 1000) throw std::runtime_error("the header has more than 1000 lines");
        if (line.compare(0, 7, "FORMAT=") == 0 && line != "FORMAT=32-bit_rle_rgbe")
            throw std::runtime_error("'" + line + "' is not supported, only FORMAT=32-bit_rle_rgbe is");
        if (line.compare(0, 9, "EXPOSURE=") == 0) header.exposure *= exposure_of(line);
    }
    const std::string line = header_line(in);
    char more;
    if (std::sscanf(line.c_str(), "-Y %9d +X %9d %c", &header.height, &header.width, &more) != 2 || header.width < 1 ||
        header.height < 1 || std::int64_t{header.width} * header.height > EnvironmentMap::max_texels)
        throw std::runtime_error("resolution line '" + line + "': it should be '-Y height +X width', with at most " +
                                 std::to_string(EnvironmentMap::max_texels) + " texels");
    return header;
}

unsigned char byte(std::istream& in) {
    const int c = in.rdbuf()->sbumpc();
    if (c == std::char_traits<char>::eof()) throw std::runtime_error("the file ends inside a scanline");
    return static_cast<unsigned char>(c);
}

Rgbe texel(std::istream& in) {
    Rgbe rgbe;
    for (unsigned char& component : rgbe) component = byte(in);
    if (rgbe[0] == 1 && rgbe[1] == 1 && rgbe[2] == 1) throw std::runtime_error("runs of before 1991: save it anew");
    return rgbe;
}

// One component of a run-length coded scanline. A code above 128 repeats the next byte code - 128 times; any other is
// followed by that many bytes.
void read_component(std::istream& in, std::vector<Rgbe>& scanline, std::size_t component) {
    for (std::size_t x = 0; x < scanline.size();) {
        const std::size_t code = byte(in), count = code > 128 ? code - 128 : code;
        if (count == 0 || count > scanline.size() - x)
            throw std::runtime_error("a run is empty, or ends after the scanline");
        const unsigned char repeated = code > 128 ? byte(in) : static_cast<unsigned char>(0);
        for (std::size_t end = x + count; x < end; ++x) scanline[x][component] = code > 128 ? repeated : byte(in);
    }
}

// Run-length coded scanlines begin with a texel (2, 2, high, low), which is no colour. All others are flat.
void read_scanline(std::istream& in, std::size_t width, std::vector<Rgbe>& scanline) {
    scanline.assign(1, texel(in));
    const auto [two, also_two, high, low] = scanline[0];
    if (two != 2 || also_two != 2 || high >= 128 || width < 8 || width > 32767) {
        while (scanline.size() < width) scanline.push_back(texel(in));
    } else {
        if (high * 256u + low != width)
            throw std::runtime_error("the scanline announces another width than the header");
        scanline.resize(width);
        for (std::size_t component = 0; component < 4; ++component) read_component(in, scanline, component);
    }
}

}  // namespace

// Without EXPOSURE radiances are exact: a mantissa has 8 bits, and 2^-135 is 2^14 times the smallest float.
EnvironmentMap read_radiance_hdr(std::istream& in) {
    const Header header = read_header(in);
    std::vector<Rgbe> scanline;
    std::vector<float> rgb;
    for (int row = 0; row < header.height; ++row) {
        read_scanline(in, static_cast<std::size_t>(header.width), scanline);
        for (const Rgbe& rgbe : scanline) {
            const float scale = rgbe[3] == 0 ? 0 : std::ldexp(1.0f, rgbe[3] - 136);
            for (std::size_t i = 0; i < 3; ++i) {
                const double radiance = rgbe[i] * static_cast<double>(scale) / header.exposure;
                if (!(radiance <= FLT_MAX)) throw std::runtime_error("a radiance is too large");
                rgb.push_back(static_cast<float>(radiance));
            }
        }
    }
    return EnvironmentMap(header.width, header.height, std::move(rgb));
}
}  // namespace bmc
