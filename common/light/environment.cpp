#include "light/environment.h"

#include "base/formatted.h"
#include "base/input.h"
#include "base/terminal.h"

#include <algorithm>
#include <array>

namespace bmc {
Colour EnvironmentMap::interpolated(double u, double v) const {
    const int columns = std::max(width - 1, 1), left = static_cast<int>(std::floor(u)) + columns;
    const int above = static_cast<int>(std::floor(v));
    const double s = u - std::floor(u), t = v - std::floor(v);
    const auto in_row = [&](int y) {
        const int clamped = std::clamp(y, 0, height - 1);
        return (1 - s) * colour(index(left % columns, clamped)) + s * colour(index((left + 1) % columns, clamped));
    };
    return (1 - t) * in_row(above) + t * in_row(above + 1);
}

// The last column and the last row have no width. They count only in a map that has no other.
Colour EnvironmentMap::bilinear_radiance(Vec3 direction) const {
    const double v = std::min(row(direction.y) - 0.5, std::max(height - 2.0, 0.0));
    return interpolated(column(direction.x, direction.z) - 0.5, v);
}

using Rgbe = std::array<unsigned char, 4>;

static std::runtime_error refusal(const std::string& problem, const std::string& options = "") {
    return std::runtime_error(problem + ": a light is a Radiance picture as `oiiotool in" + options +
                              " -o out.hdr` writes it");
}

// Without the white space at its end.
static std::string header_line(std::istream& in) {
    char line[4096];
    if (!in.getline(line, sizeof line))
        throw std::runtime_error("the header ends early, or has a line of more than 4095 bytes");
    const std::string text = line;
    return text.substr(0, text.find_last_not_of(" \t\r") + 1);
}

struct Header {
    int width = 0, height = 0;
    double exposure = 1;  // the values of the file are so many times the true ones
};

// Some programs write 0, which would leave no light.
static double exposure_of(const std::string& value) {
    char* end = nullptr;
    const double exposure = std::strtod(value.c_str(), &end);
    if (exposure != 0 || end == value.c_str()) return exposure;
    print_note("note: the light's EXPOSURE=0 counts as 1");
    return 1;
}

// Other variables do not count, as for Radiance itself.
static Header read_header(std::istream& in) {
    in.exceptions(std::ios::badbit);  // an error of reading does not end the file
    if (in.get() != '#' || in.get() != '?') throw refusal("its first line does not begin with #?");
    header_line(in);
    Header header;
    int lines = 0;
    for (std::string line = header_line(in); !line.empty(); line = header_line(in)) {
        if (++lines > 1000) throw std::runtime_error("the header has more than 1000 lines");
        const std::string name = line.substr(0, line.find('=') + 1), value = line.substr(name.size());
        if (name == "EXPOSURE=") header.exposure *= exposure_of(value);
        if (name == "FORMAT=" && value.find("32-bit_rle_rgbe") == value.npos) throw refusal("'" + line + "'");
    }
    if (!(header.exposure >= 1e-6 && header.exposure <= 1e6))
        throw std::runtime_error("the product of the EXPOSURE lines is not from 1e-6 to 1e6");
    const std::string divided =  // by what oiiotool drops
        header.exposure == 1 ? "" : formatted(" --divc %.9g", header.exposure);
    const std::string line = header_line(in);
    int end = 0;
    std::sscanf(line.c_str(), "-Y %9d +X %9d%n", &header.height, &header.width, &end);
    if (end != static_cast<int>(line.size()) || header.height < 1 || header.width < 1)
        throw refusal("resolution line '" + line + "' is not '-Y height +X width'", " --reorient" + divided);
    if (std::int64_t{header.height} * header.width > EnvironmentMap::max_texels)
        throw std::runtime_error(
            formatted("%d x %d texels are more than %d; `oiiotool in%s --resize 4096x0 -o out.hdr` makes fewer",
                      header.width, header.height, EnvironmentMap::max_texels, divided.c_str()));
    return header;
}

static unsigned char byte(std::istream& in) {
    const int c = in.rdbuf()->sbumpc();
    if (c == std::char_traits<char>::eof()) throw std::runtime_error("the file ends inside a scanline");
    return static_cast<unsigned char>(c);
}

// One component of a run-length coded scanline. A code above 128 repeats the next byte code - 128 times; any other is
// followed by that many bytes.
static void read_component(std::istream& in, Rgbe* scanline, std::size_t width, std::size_t component) {
    for (std::size_t x = 0; x < width;) {
        const std::size_t code = byte(in), count = code > 128 ? code - 128 : code;
        if (count == 0 || count > width - x) throw std::runtime_error("a run is empty, or ends after the scanline");
        const unsigned char repeated = code > 128 ? byte(in) : static_cast<unsigned char>(0);
        for (std::size_t end = x + count; x < end; ++x) scanline[x][component] = code > 128 ? repeated : byte(in);
    }
}

// A coded scanline begins with a texel (2, 2, high, low), which is no colour. Before 1991 (1, 1, 1, n) was a run.
static void read_scanline(std::istream& in, std::size_t width, std::vector<Rgbe>& texels) {
    for (std::size_t x = 0; x < width; ++x) {
        const auto [red, green, blue, exponent] = Rgbe{byte(in), byte(in), byte(in), byte(in)};  // in this order
        if (x == 0 && red == 2 && green == 2 && blue < 128 && width >= 8 && width <= 32767) {
            if (blue * 256u + exponent != width) throw std::runtime_error("a scanline has a wrong width");
            texels.resize(texels.size() + width);
            for (std::size_t k = 0; k < 4; ++k) read_component(in, &texels[texels.size() - width], width, k);
            return;
        }
        if (red == 1 && green == 1 && blue == 1) throw refusal("a scanline has a run of before 1991");
        texels.push_back({red, green, blue, exponent});
    }
}

EnvironmentMap read_radiance_hdr(std::istream& in) {
    const auto [width, height, exposure] = read_header(in);
    std::vector<Rgbe> texels;  // grows with what the file holds, whatever its header says
    for (int y = 0; y < height; ++y) read_scanline(in, static_cast<std::size_t>(width), texels);
    EnvironmentMap map(width, height);
    for (int i = 0; i < width * height; ++i) {
        const auto [red, green, blue, exponent] = texels[static_cast<std::size_t>(i)];
        // Without an exposure this is exact: a mantissa has 8 bits, and 2^-135 is 2^14 times the smallest float.
        const double unit = exponent == 0 ? 0 : std::ldexp(1.0, exponent - 136);
        const Colour colour{red * unit / exposure, green * unit / exposure, blue * unit / exposure};
        if (!(std::max({colour.x, colour.y, colour.z}) <= 1e36))  // whose integrals are floats, too
            throw std::runtime_error("a radiance exceeds 1e36");
        map.set(i % width, i / width, colour);
    }
    return map;
}

std::vector<std::string> light_names() { return {std::begin(built_in_lights), std::end(built_in_lights)}; }

std::string environment_help() { return "a .hdr (-: stdin), " + listed(light_names()); }

EnvironmentMap load_environment(const std::string& name, std::size_t threads) {
    for (std::size_t i = 0; i < std::size(built_in_lights); ++i)
        if (name == built_in_lights[i]) return built_in_light(static_cast<BuiltInLight>(i), threads);
    return read_file(name, read_radiance_hdr, "; lights with a name are " + listed(light_names()));
}
}  // namespace bmc
