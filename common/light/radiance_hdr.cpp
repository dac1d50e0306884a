#include "light/load_environment.h"

#include <array>
#include <cstdio>
#include <istream>
#include <stdexcept>

namespace bmc {
using Rgbe = std::array<unsigned char, 4>;

static std::string header_line(std::istream& in) {
    char line[4096];
    if (!in.getline(line, sizeof line))
        throw std::runtime_error(in.eof() ? "the file ends inside the header" : "a line of the header is too long");
    std::string text = line;
    if (!text.empty() && text.back() == '\r') text.pop_back();
    return text;
}

constexpr const char* converter = "; `oiiotool in -o out.hdr` converts it";

static bool begins_with(const std::string& text, const std::string& beginning) {
    return text.compare(0, beginning.size(), beginning) == 0;
}

// The text after the first '=', without blanks around it.
static std::string value_in(const std::string& line) {
    const std::size_t begin = line.find_first_not_of(" \t", line.find('=') + 1), end = line.find_last_not_of(" \t");
    return begin == std::string::npos ? "" : line.substr(begin, end - begin + 1);
}

// The header, and what it says of each channel: the radiances of the file are so many times the true ones.
struct Header {
    int width, height;
    double factors[3] = {1, 1, 1};
};

// EXPOSURE has one factor, COLORCORR one for each channel. Several lines multiply.
static void multiply(Header& header, const std::string& line, std::vector<std::string>& notes) {
    double f[3] = {0, 0, 0};
    char more;
    const std::string value = value_in(line);
    bool right = std::sscanf(value.c_str(), "%lf %lf %lf %c", &f[0], &f[1], &f[2], &more) == 3;
    if (begins_with(line, "EXPOSURE=")) {
        right = std::sscanf(value.c_str(), "%lf %c", &f[0], &more) == 1;
        f[1] = f[2] = f[0];
    }
    for (const double factor : f) right = right && factor >= 1e-6 && factor <= 1e6;
    if (!right) notes.push_back("'" + line + "' is not from 1e-6 to 1e6, and counts as 1");
    for (int i = 0; right && i < 3; ++i) header.factors[i] *= f[i];
}

// The first line is #? and the name of a program, any.
static void read_signature(std::istream& in) {
    char start[9] = {};
    if (in.peek() != '#') in.get(start, sizeof start, '\0');
    if (begins_with(start, "v/1\1")) throw std::runtime_error(std::string("an OpenEXR picture") + converter);
    if (begins_with(start, "version ")) throw std::runtime_error("a pointer of git-lfs; `git lfs pull` gets the file");
    if (*start || !begins_with(header_line(in), "#?"))
        throw std::runtime_error(std::string("not a Radiance picture, whose first line begins with #?") + converter);
}

static Header read_header(std::istream& in, std::vector<std::string>& notes) {
    in.exceptions(std::ios::badbit);  // an error of reading does not end the file
    read_signature(in);
    Header header{};
    int lines = 0;
    for (std::string line = header_line(in); !line.empty(); line = header_line(in)) {
        if (++lines > 1000) throw std::runtime_error("the header has more than 1000 lines");
        if (begins_with(line, "FORMAT=") && value_in(line) != "32-bit_rle_rgbe")
            throw std::runtime_error("'" + line + "' is not supported, only 32-bit_rle_rgbe is" + converter);
        if (begins_with(line, "EXPOSURE=") || begins_with(line, "COLORCORR=")) multiply(header, line, notes);
    }
    const std::string line = header_line(in);
    char a, b, c, d, more;
    if (std::sscanf(line.c_str(), "%c%c %9d %c%c %9d %c", &a, &b, &header.height, &c, &d, &header.width, &more) != 6 ||
        header.height < 1 || header.width < 1 ||
        std::int64_t{header.height} * header.width > EnvironmentMap::max_texels)
        throw std::runtime_error("resolution line '" + line + "': it should be '-Y height +X width', with at most " +
                                 std::to_string(EnvironmentMap::max_texels) + " texels");
    if (a != '-' || b != 'Y' || c != '+' || d != 'X')
        throw std::runtime_error("'" + line + "' is an orientation that is not supported, only -Y +X is" + converter);
    return header;
}

static unsigned char byte(std::istream& in) {
    const int c = in.rdbuf()->sbumpc();
    if (c == std::char_traits<char>::eof()) throw std::runtime_error("the file ends inside a scanline");
    return static_cast<unsigned char>(c);
}

static Rgbe texel(std::istream& in) {
    Rgbe rgbe;
    for (unsigned char& component : rgbe) component = byte(in);
    if (rgbe[0] == 1 && rgbe[1] == 1 && rgbe[2] == 1)
        throw std::runtime_error(std::string("its runs are of before 1991") + converter);
    return rgbe;
}

// One component of a run-length coded scanline. A code above 128 repeats the next byte code - 128 times; any other is
// followed by that many bytes.
static void read_component(std::istream& in, std::vector<Rgbe>& scanline, std::size_t component) {
    for (std::size_t x = 0; x < scanline.size();) {
        const std::size_t code = byte(in), count = code > 128 ? code - 128 : code;
        if (count == 0 || count > scanline.size() - x)
            throw std::runtime_error("a run is empty, or ends after the scanline");
        const unsigned char repeated = code > 128 ? byte(in) : static_cast<unsigned char>(0);
        for (std::size_t end = x + count; x < end; ++x) scanline[x][component] = code > 128 ? repeated : byte(in);
    }
}

// Run-length coded scanlines begin with a texel (2, 2, high, low), which is no colour. All others are flat.
static void read_scanline(std::istream& in, std::size_t width, std::vector<Rgbe>& scanline) {
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

// Without factors radiances are exact: a mantissa has 8 bits, and 2^-135 is 2^14 times the smallest float.
EnvironmentMap read_radiance_hdr(std::istream& in, std::vector<std::string>& notes) {
    const Header header = read_header(in, notes);
    std::vector<Rgbe> scanline;
    std::vector<float> rgb;
    for (int row = 0; row < header.height; ++row) {
        read_scanline(in, static_cast<std::size_t>(header.width), scanline);
        for (const Rgbe& rgbe : scanline) {
            const double scale = rgbe[3] == 0 ? 0 : std::ldexp(1.0, rgbe[3] - 136);
            for (std::size_t i = 0; i < 3; ++i) {
                const double radiance = rgbe[i] * scale / header.factors[i];
                if (!(radiance <= FLT_MAX)) throw std::runtime_error("a radiance is too large");
                rgb.push_back(static_cast<float>(radiance));
            }
        }
    }
    if (in.peek() != std::char_traits<char>::eof())
        notes.push_back("bytes follow the last scanline; is the picture as it should be?");
    return EnvironmentMap(header.width, header.height, std::move(rgb));
}
}  // namespace bmc
