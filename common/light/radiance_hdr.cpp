#include "light/radiance_hdr.h"

#include "numerics/formatted.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <istream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace bmc {
namespace {

class RadianceReader {
public:
    explicit RadianceReader(std::streambuf& bytes) : bytes_(bytes) {}

    EnvironmentMap read() {
        read_header();
        rgb_.reserve(3 * static_cast<std::size_t>(std::min<std::int64_t>(std::int64_t{width_} * height_, 1 << 20)));
        for (row_ = 0; row_ < height_; ++row_) read_scanline();
        return EnvironmentMap(width_, height_, std::move(rgb_));
    }

private:
    using Rgbe = std::array<unsigned char, 4>;

    [[noreturn]] void fail(const std::string& problem) const {
        throw std::runtime_error(row_ < 0 ? problem : "row " + std::to_string(row_) + ": " + problem);
    }

    std::string header_line() {
        std::string line;
        for (int c = bytes_.sbumpc(); c != '\n'; c = bytes_.sbumpc()) {
            if (c == end_of_file) fail("the file ends inside the header");
            line += static_cast<char>(c);
            if (line.size() > 4096) fail("a line of the header is longer than 4096 characters");
        }
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
        return line;
    }

    void read_header() {
        const bool hash = bytes_.sbumpc() == '#', question_mark = bytes_.sbumpc() == '?';
        const std::string program = hash && question_mark ? header_line() : "";
        if (program != "RADIANCE" && program != "RGBE")
            fail("not a Radiance picture: its first line should be #?RADIANCE or #?RGBE");
        for (std::string line = header_line(); !line.empty(); line = header_line())
            if (line.compare(0, 7, "FORMAT=") == 0 && line.substr(line.find_last_of("= ") + 1) != "32-bit_rle_rgbe")
                fail("format '" + line.substr(7) + "' is not supported, only 32-bit_rle_rgbe is");
        read_size(header_line());
    }

    void read_size(const std::string& line) {
        std::istringstream words(line);
        std::string y, x, more;
        words >> y >> height_ >> x >> width_;
        if (!words || words >> more || y != "-Y" || x != "+X" || width_ < 1 || height_ < 1)
            fail("resolution line '" + line + "' is not supported, only '-Y height +X width' is");
        if (std::int64_t{width_} * height_ > EnvironmentMap::max_texels)
            fail(formatted("a picture of %d x %d texels exceeds the limit of %d", width_, height_,
                           EnvironmentMap::max_texels));
    }

    unsigned char byte() {
        const int c = bytes_.sbumpc();
        if (c == end_of_file) fail("the file ends inside a scanline");
        return static_cast<unsigned char>(c);
    }

    // No encoder writes the mantissas 1, 1, 1 for a colour: the largest is at least 128.
    Rgbe texel() {
        Rgbe rgbe;
        for (unsigned char& component : rgbe) component = byte();
        if (rgbe[0] == 1 && rgbe[1] == 1 && rgbe[2] == 1)
            fail("runs of the oldest kind are not supported; save the picture again by another program");
        return rgbe;
    }

    // Exact: 8 bits of mantissa, and 2^-135 is 2^14 times the smallest float.
    void append(const Rgbe& rgbe) {
        const float scale = rgbe[3] == 0 ? 0 : std::ldexp(1.0f, rgbe[3] - 136);
        for (std::size_t i = 0; i < 3; ++i) rgb_.push_back(static_cast<float>(rgbe[i]) * scale);
    }

    // Run-length coded scanlines begin with a texel (2, 2, high, low), which is no colour either. All others are flat.
    void read_scanline() {
        const Rgbe first = texel();
        if (first[0] != 2 || first[1] != 2 || first[2] >= 128 || width_ < 8 || width_ > 32767) {
            append(first);
            for (int x = 1; x < width_; ++x) append(texel());
            return;
        }
        const int announced = first[2] * 256 + first[3];
        if (announced != width_) fail(formatted("the scanline announces %d texels instead of %d", announced, width_));
        scanline_.resize(static_cast<std::size_t>(width_));
        for (std::size_t component = 0; component < 4; ++component) read_component(component);
        for (const Rgbe& rgbe : scanline_) append(rgbe);
    }

    // A code above 128: the next byte, code - 128 times. Otherwise: that many bytes follow.
    void read_component(std::size_t component) {
        for (std::size_t x = 0; x < scanline_.size();) {
            const std::size_t code = byte(), count = code > 128 ? code - 128 : code;
            if (count == 0) fail("a run of length 0");
            if (count > scanline_.size() - x) fail("a run goes past the end of the scanline");
            const unsigned char repeated = code > 128 ? byte() : static_cast<unsigned char>(0);
            for (std::size_t end = x + count; x < end; ++x) scanline_[x][component] = code > 128 ? repeated : byte();
        }
    }

    static constexpr int end_of_file = std::char_traits<char>::eof();

    std::streambuf& bytes_;
    int row_ = -1, width_ = 0, height_ = 0;
    std::vector<Rgbe> scanline_;
    std::vector<float> rgb_;
};

}  // namespace

EnvironmentMap read_radiance_hdr(std::istream& in) { return RadianceReader(*in.rdbuf()).read(); }

std::string to_radiance_hdr(const EnvironmentMap& map) {
    std::string bytes = formatted("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y %d +X %d\n", map.height(), map.width());
    const auto append = [&](double byte) { bytes += static_cast<char>(static_cast<unsigned char>(byte)); };
    const float* const end = map.texels() + 3 * std::ptrdiff_t{map.width()} * map.height();
    for (const float* rgb = map.texels(); rgb != end; rgb += 3) {
        const double largest = std::max({rgb[0], rgb[1], rgb[2]});
        int e;  // largest = m 2^e with m in [1/2, 1); one more where the mantissa rounds to 256
        if (std::frexp(largest, &e) * 256 >= 255.5) ++e;
        e = largest > 0 ? std::clamp(e, -127, 127) : -127;
        for (int i = 0; i < 3; ++i) append(std::min(std::floor(std::ldexp(double{rgb[i]}, 8 - e) + 0.5), 255.0));
        append(e + 128);
    }
    return bytes;
}
}  // namespace bmc
