// Light from infinitely far away: a map of radiance over all directions. A map of W x H texels has rows of constant
// elevation, row 0 around +y, and columns of constant azimuth, -z in the middle and +x to the right of it. A direction
// meets column floor(u (W - 1)) and row floor(v (H - 1)), where u = (1 + atan2(x, -z) / pi) / 2 and v = acos(y) / pi.
// (So it meets the last column or row only if u or v is 1. This is the convention of the practice's base code.)
#pragma once

#include "base/vec3.h"

#include <algorithm>
#include <iosfwd>
#include <string>
#include <vector>

namespace bmc {
class EnvironmentMap {
public:
    static constexpr int max_texels = 1 << 26;
    const int width, height;

    // Black, with 1 to max_texels texels, to be filled with linear RGB radiances, finite and >= 0; row 0 at the top.
    // One more texel, number 0, belongs to no direction: it stays black, for rays in the shadow.
    EnvironmentMap(int columns, int rows)
        : width(columns),
          height(rows),
          rgb_(3 + 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}
    void set(int x, int y, Colour radiance) {
        float* rgb = &rgb_[3 * static_cast<std::size_t>(index(x, y))];
        for (const double channel : {radiance.x, radiance.y, radiance.z}) *rgb++ = static_cast<float>(channel);
    }

    // Where a direction falls: u (W - 1) and v (H - 1), with their fractions.
    double column(double x, double z) const {
        return (0.5 + 0.5 / portable::pi * portable::azimuth(x, z)) * (width - 1);
    }
    double row(double y) const { return 1 / portable::pi * portable::arccosine(y) * (height - 1); }

    // The number of the texel in column x of row y.
    int index(int x, int y) const { return 1 + y * width + x; }
    Colour colour(int i) const {
        const float* rgb = &rgb_[3 * static_cast<std::size_t>(i)];
        return {rgb[0], rgb[1], rgb[2]};
    }

    // The number of the texel that a direction of unit length meets. This runs for every ray: it is arithmetic without
    // a branch, which a compiler computes for several rays at once. Rounding can carry u or v past 0 or 1, and the
    // conversion to int drops that error. azimuth and arccosine are polynomials; in a map 1024 wide their error is 4e-6
    // of a texel.
    int index(Vec3 direction) const {
        return index(static_cast<int>(column(direction.x, direction.z)), static_cast<int>(row(direction.y)));
    }

    // Linear RGB radiance that arrives from a direction of unit length: that of its texel.
    Colour radiance(Vec3 direction) const { return colour(index(direction)); }

    // The same interpolated between the centres of the four nearest texels: for the background, where an eye would see
    // their edges.
    Colour bilinear_radiance(Vec3 direction) const;

    // Between four texels: column u >= -1, where the last column repeats the first one, and row v; or those around a
    // direction, in a table of values at the corners of texels.
    Colour interpolated(double u, double v) const;
    Colour interpolated(Vec3 direction) const {
        return interpolated(column(direction.x, direction.z), row(direction.y));
    }

private:
    std::vector<float> rgb_;  // of texels 0, 1, ...
};

// The texels of a map as pieces of the sphere. The last column and row have no area (see above) and are left out,
// unless there is no other. If there are too few texels, each is cut into equal pieces.
struct TexelsOnSphere {
    const EnvironmentMap& map;
    const int across, down;  // pieces of a texel
    const int columns, rows;

    explicit TexelsOnSphere(const EnvironmentMap& texels, int min_columns = 1, int min_rows = 1)
        : map(texels),
          across(1 + (min_columns - 1) / std::max(1, map.width - 1)),
          down(1 + (min_rows - 1) / std::max(1, map.height - 1)),
          columns(across * std::max(1, map.width - 1)),
          rows(down * std::max(1, map.height - 1)) {}

    Colour operator()(int row, int column) const { return map.colour(map.index(column / across, row / down)); }

    // The solid angle of one texel of the row.
    double solid_angle(int row) const {
        return 2 * portable::pi / columns * (polar(row).cosine - polar(row + 1).cosine);
    }

    // Sine and cosine of the polar angle at this height, counted in rows: row + 0.5 is the middle of a row.
    portable::SineCosine polar(double height) const { return portable::sincos_turns(0.5 * height / rows); }

    // Sine and cosine of the azimuth at this place, counted in columns from +z over -x.
    portable::SineCosine azimuth(double place) const { return portable::sincos_turns(place / columns - 0.5); }
};

// The direction (sin(polar) sin(azimuth), cos(polar), -sin(polar) cos(azimuth)).
inline Vec3 direction_of(portable::SineCosine polar, portable::SineCosine azimuth) {
    return {polar.sine * azimuth.sine, polar.cosine, -polar.sine * azimuth.cosine};
}

// The mean over all directions of f(L).
template <class Function>
double mean_over_directions(const EnvironmentMap& map, Function f) {
    const TexelsOnSphere texels(map);
    double sum = 0;
    for (int row = 0; row < texels.rows; ++row) {
        double row_sum = 0;
        for (int column = 0; column < texels.columns; ++column) row_sum += f(texels(row, column));
        sum += texels.solid_angle(row) * row_sum;
    }
    return sum / (4 * portable::pi);
}

// The built-in lights are maps of 1024 x 512 texels:
// - desert: an arch of sandstone around -z and the sun high on the right, behind a camera that looks at the arch;
//   radiance in [0, 1].
// - bright-desert: the same with a sun a thousand times as bright, as real suns are: it sends four fifths of the light.
// - black-and-white: the hardest light without a sun: radiance 1 where x > 0, and 0 elsewhere.
enum class BuiltInLight { desert, bright_desert, black_and_white };
inline constexpr const char* built_in_lights[] = {"desert", "bright-desert", "black-and-white"};
EnvironmentMap built_in_light(BuiltInLight light, std::size_t threads = 1);

// Reads a Radiance picture (.hdr; Ward, "Real Pixels", Graphics Gems II, 1991) from a binary stream, of the usual kind:
// 32-bit_rle_rgbe, rows from the top left, flat or run-length coded. Linear RGB radiance = mantissa * 2^(exponent -
// 136), exactly, divided by the product of the EXPOSURE lines (0 counts as 1, with a note). Memory grows with what the
// file holds. Throws std::runtime_error: one line with the problem, and what converts a picture of another kind.
EnvironmentMap read_radiance_hdr(std::istream& in);

std::vector<std::string> light_names();

// The help text of an option that takes the name of a light.
std::string environment_help();

// The built-in light of this name, or else the one in the .hdr file; "-" is standard input. threads: how many to use.
// Throws std::runtime_error, one line that names the file.
EnvironmentMap load_environment(const std::string& name = "desert", std::size_t threads = 1);
}  // namespace bmc
