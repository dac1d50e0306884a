#include "light/load_environment.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <istream>
#include <set>
#include <stdexcept>

namespace bmc {
using Rgbe = std::array<unsigned char, 4>;

static bool begins_with(const std::string& text, const std::string& beginning) {
    return text.compare(0, beginning.size(), beginning) == 0;
}

struct Header {
    char signs[2][2], names[2][2];  // of the axis of the scanlines, and of that of the texels in each
    int counts[2];
    double factors[3] = {1, 1, 1};  // a channel of the file is so many times the true one
    bool is_xyz = false;
};

// Without the white space at its end.
static std::string header_line(std::istream& in) {
    char line[4096];
    if (!in.getline(line, sizeof line))
        throw std::runtime_error(in.eof() ? "the file ends inside the header"
                                          : "a line of the header is longer than 4095 bytes; delete it, or its end");
    const std::string text = line;
    return text.substr(0, text.find_last_not_of(" \t\r") + 1);
}

// The colours that Radiance takes as standard. Those of sRGB are near them.
constexpr double standard_primaries[] = {0.64, 0.33, 0.29, 0.6, 0.15, 0.06, 0.333, 0.333};

// EXPOSURE has one factor, COLORCORR one for each channel. Several lines multiply. Photoshop's PRIMARIES are zeros.
static void read_variable(std::string line, Header& header, std::vector<std::string>& notes) {
    std::array<double, 8> numbers;  // zeros from the first that is none
    char* rest = line.data() + std::min(line.find('='), line.size() - 1) + 1;
    for (double& number : numbers) number = std::strtod(rest, &rest);
    const auto near = [](double a, double b) { return std::fabs(a - b) < 0.025; };
    const auto fits = [](double factor) { return factor >= 1e-6 && factor <= 1e6; };
    if (begins_with(line, "PRIMARIES=") && numbers[0] != 0 &&
        !std::equal(numbers.begin(), numbers.end(), standard_primaries, near))
        notes.push_back("'" + line + "' is not converted: its colours count as the standard ones");
    if (begins_with(line, "EXPOSURE=")) numbers.fill(numbers[0]);
    if (!begins_with(line, "EXPOSURE=") && !begins_with(line, "COLORCORR=")) return;
    if (!std::all_of(numbers.begin(), numbers.begin() + 3, fits))
        return notes.push_back("'" + line + "' is not from 1e-6 to 1e6, and counts as 1");
    for (std::size_t i = 0; i < 3; ++i) header.factors[i] *= numbers[i];
}

constexpr const char* converter = "; `oiiotool in -o out.hdr` converts it";
constexpr const char* decoder = "; `oiiotool in --colorconvert sRGB linear -o out.hdr` makes light of them";

// What files of other kinds begin with, and what makes light of them.
constexpr const char* others[][3] = {{"v/1\1", "an OpenEXR picture", converter},
                                     {"II*", "a TIFF picture", converter},
                                     {"MM", "a TIFF picture", converter},
                                     {"PF", "a PFM picture", converter},
                                     {"\x89PNG", "a PNG picture, which holds codes", decoder},
                                     {"\xff\xd8", "a JPEG picture, which holds codes", decoder},
                                     {"version ", "a pointer of git-lfs", "; `git lfs pull` gets the file"},
                                     {"", "not a Radiance picture, whose first line begins with #?", ""}};

// The first line is #? and the name of a program, any.
static void read_signature(std::istream& in) {
    if (in.peek() == '#' && begins_with(header_line(in), "#?")) return;
    char start[9] = {};
    in.get(start, sizeof start, '\0');
    for (const auto& [beginning, kind, cure] : others)
        if (begins_with(start, beginning)) throw std::runtime_error(std::string(kind) + cure);
}

static Header read_header(std::istream& in, std::vector<std::string>& notes) {
    in.exceptions(std::ios::badbit);  // an error of reading does not end the file
    read_signature(in);
    Header header{};
    int lines = 0;
    for (std::string line = header_line(in); !line.empty(); line = header_line(in)) {
        if (++lines > 1000)
            throw std::runtime_error("the header has more than 1000 lines; delete those that have no '='");
        read_variable(line, header, notes);
        if (!begins_with(line, "FORMAT=")) continue;
        const std::string format = line.substr(line.find_last_of("= \t") + 1);
        header.is_xyz = format == "32-bit_rle_xyze";
        if (!header.is_xyz && format != "32-bit_rle_rgbe")
            throw std::runtime_error("'" + line + "' is neither 32-bit_rle_rgbe nor 32-bit_rle_xyze");
    }
    const std::string line = header_line(in);
    char more;
    auto& [signs, names, counts, factors, is_xyz] = header;
    if (std::sscanf(line.c_str(), "%1[-+]%1[XY] %9d %1[-+]%1[XY] %9d %c", signs[0], names[0], &counts[0], signs[1],
                    names[1], &counts[1], &more) != 6 ||
        *names[0] == *names[1] || counts[0] < 1 || counts[1] < 1 ||
        std::int64_t{counts[0]} * counts[1] > EnvironmentMap::max_texels)
        throw std::runtime_error("resolution line '" + line + "': it should be '-Y height +X width', with at most " +
                                 std::to_string(EnvironmentMap::max_texels) + " texels");
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

// Run-length coded scanlines begin with a texel (2, 2, high, low), which is no colour. In the others, as before 1991, a
// texel (1, 1, 1, n) repeats the one before n times, and another behind it 256 times as often.
static void read_scanline(std::istream& in, std::size_t width, std::vector<Rgbe>& scanline) {
    Rgbe next = texel(in);
    const auto [two, also_two, high, low] = next;
    if (two == 2 && also_two == 2 && high < 128 && width >= 8 && width <= 32767) {
        if (high * 256u + low != width)
            throw std::runtime_error("the scanline announces another width than the header");
        scanline.resize(width);
        for (std::size_t component = 0; component < 4; ++component) read_component(in, scanline, component);
        return;
    }
    scanline.clear();
    for (std::size_t unit = 1;; next = texel(in)) {
        const bool repeats = next[0] == 1 && next[1] == 1 && next[2] == 1;
        const std::size_t count = repeats ? next[3] * unit : 1;
        if ((repeats && scanline.empty()) || count > width - scanline.size())
            throw std::runtime_error("a run has no texel before it, or ends after the scanline");
        scanline.insert(scanline.end(), count, repeats ? scanline.back() : next);
        if (scanline.size() == width) return;
        unit = repeats ? std::min(unit * 256, std::size_t{1} << 24) : 1;
    }
}

// CIE XYZ to RGB of Radiance's standard primaries, as in its spec_rgb.c. XYZ counts lumens, of which a watt has 179.
constexpr Vec3 rgb_of_xyz[] = {
    {2.5653128, -1.1668496, -0.3984632}, {-1.0221082, 1.9782866, 0.0438216}, {0.0747244, -0.2519396, 1.1772152}};

// Without factors RGB is exact: a mantissa has 8 bits, and 2^-135 is 2^14 times the smallest float.
static Colour radiance(const Rgbe& rgbe, const Header& header) {
    const double scale = rgbe[3] == 0 ? 0 : std::ldexp(1.0, rgbe[3] - 136);
    const double* factors = header.factors;
    Colour colour{rgbe[0] * scale / factors[0], rgbe[1] * scale / factors[1], rgbe[2] * scale / factors[2]};
    if (header.is_xyz) {
        const auto channel = [&](Vec3 row) { return std::max(0.0, dot(row, colour)) / 179; };
        colour = {channel(rgb_of_xyz[0]), channel(rgb_of_xyz[1]), channel(rgb_of_xyz[2])};
    }
    if (!(std::max({colour.x, colour.y, colour.z}) <= FLT_MAX)) throw std::runtime_error("a radiance is too large");
    return colour;
}

// Whether the map has only values that an 8-bit picture has, whole numbers up to 256 or so many 256ths, and many of
// them.
static bool holds_codes(const EnvironmentMap& map) {
    std::set<double> values;  // up to one more than such a picture has
    for (int i = 1; i <= map.width * map.height && values.size() <= 257; ++i)
        values.insert({map.colour(i).x, map.colour(i).y, map.colour(i).z});
    const double codes = *values.rbegin() > 1 ? 1 : 256;  // in a radiance of 1
    return values.size() > 32 && std::all_of(values.begin(), values.end(), [&](double value) {
               return codes * value <= 256 && codes * value == std::floor(codes * value);
           });
}

EnvironmentMap read_radiance_hdr(std::istream& in, std::vector<std::string>& notes) {
    const Header header = read_header(in, notes);
    const int* counts = header.counts;
    std::vector<Rgbe> texels, scanline;
    for (int i = 0; i < counts[0]; ++i) {
        read_scanline(in, static_cast<std::size_t>(counts[1]), scanline);
        texels.insert(texels.end(), scanline.begin(), scanline.end());
    }
    if (in.peek() != std::char_traits<char>::eof())
        notes.push_back("bytes follow the last scanline; is the picture as it should be?");
    EnvironmentMap map(counts[*header.names[0] == 'Y'], counts[*header.names[0] == 'X']);
    for (int i = 0; i < counts[0] * counts[1]; ++i) {
        const int numbers[] = {i / counts[1], i % counts[1]};
        int place[2];
        for (const int axis : {0, 1}) {
            const bool is_y = *header.names[axis] == 'Y', backward = *header.signs[axis] == (is_y ? '+' : '-');
            place[is_y] = backward ? counts[axis] - 1 - numbers[axis] : numbers[axis];
        }
        map.set(place[0], place[1], radiance(texels[static_cast<std::size_t>(i)], header));
    }
    if (holds_codes(map))
        notes.push_back(std::string("its values are the codes of an 8-bit picture, not radiances") + decoder);
    return map;
}
}  // namespace bmc
