// Light from infinitely far away: a map of radiance over all directions.
//
// A map of W x H texels has rows of constant elevation, row 0 around +y, and columns of constant azimuth, -z in the
// middle and +x to the right of it. With u = (1 + atan2(x, -z) / pi) / 2 and v = acos(y) / pi, a direction meets
// column floor(u (W - 1)) and row floor(v (H - 1)); the last of them are met only where u or v is 1.
#pragma once

#include "numerics/portable_math.h"
#include "numerics/vec3.h"

#include <cmath>
#include <cstddef>
#include <vector>

// The texels of a map of so many columns and rows, apart from their radiance: a loop over directions copies it, so that
// the compiler need not fear for it when texel indices are stored.
class TexelGrid {
public:
    TexelGrid(int columns, int rows) : width_(columns), last_column_(columns - 1.0), last_row_(rows - 1.0) {}

    // Row * width_ + column of the texel that a direction sees. The direction has unit length up to rounding. Anything
    // else, nan included, still gives a texel of the map.
    //
    // This runs for every secondary ray, so it is a straight line of arithmetic that a compiler can turn into SIMD over
    // arrays of directions. Arccosine and arctangent are polynomials with an error of at most 2.3e-8: a texel's
    // border moves by 2.3e-8 / (2 pi) * 1023 = 4e-6 of a texel in a map 1024 wide.
    int texel_index(double x, double y, double z) const {
        return static_cast<int>(row(y)) * width_ + static_cast<int>(column(x, z));
    }

    // v (H - 1) and u (W - 1), for those who look between texels.
    double row(double y) const { return clamp(arccosine(y) * (1 / portable::pi) * last_row_, last_row_); }
    double column(double x, double z) const {
        return clamp((0.5 + azimuth(x, z) * (0.5 / portable::pi)) * last_column_, last_column_);
    }

    int width() const { return width_; }

private:
    // To [0, last]; the order of the comparisons sends nan to 0.
    static double clamp(double t, double last) {
        const double not_negative = t > 0 ? t : 0;
        return not_negative < last ? not_negative : last;
    }

    // Abramowitz & Stegun, Handbook of Mathematical Functions (1964), 4.4.46: acos(a) = sqrt(1 - a) P7(a) on [0, 1],
    // and acos(-a) = pi - acos(a).
    static double arccosine(double y) {
        const double a = std::fabs(y);
        double p = -0.0012624911;
        p = p * a + 0.0066700901;
        p = p * a - 0.0170881256;
        p = p * a + 0.0308918810;
        p = p * a - 0.0501743046;
        p = p * a + 0.0889789874;
        p = p * a - 0.2145988016;
        p = p * a + 1.5707963050;
        const double from_pole = std::sqrt(a < 1 ? 1 - a : 0) * p;
        return y < 0 ? portable::pi - from_pole : from_pole;
    }

    // atan2(x, -z) by Abramowitz & Stegun 4.4.49, atan(t) = t P8(t^2) on [0, 1], and the symmetries of the octants.
    // The smallest normal number in the denominator gives straight up and straight down the azimuth 0.
    static double azimuth(double x, double z) {
        const double across = std::fabs(x), along = std::fabs(z);
        const double longer = across > along ? across : along;
        const double t = (across > along ? along : across) / (longer > DBL_MIN ? longer : DBL_MIN);
        const double t2 = t * t;
        double p = 0.0028662257;
        p = p * t2 - 0.0161657367;
        p = p * t2 + 0.0429096138;
        p = p * t2 - 0.0752896400;
        p = p * t2 + 0.1065626393;
        p = p * t2 - 0.1420889944;
        p = p * t2 + 0.1999355085;
        p = p * t2 - 0.3333314528;
        p = p * t2 + 1;
        const double octant = t * p;
        const double quadrant = across > along ? portable::pi / 2 - octant : octant;
        const double half = z > 0 ? portable::pi - quadrant : quadrant;
        return x < 0 ? -half : half;
    }

    int width_;
    double last_column_, last_row_;
};

class EnvironmentMap {
public:
    static constexpr int max_texels = 1 << 26;

    // rgb: linear RGB radiance, interleaved, height rows of width texels, row 0 at the top.
    // Throws std::invalid_argument unless width, height >= 1, width * height <= max_texels, and rgb holds
    // 3 * width * height values, all of them finite and >= 0.
    EnvironmentMap(int width, int height, std::vector<float> rgb);

    int width() const { return grid_.width(); }
    int height() const { return height_; }

    // Linear RGB radiance; texel i is at 3 i, 3 i + 1, 3 i + 2.
    const float* texels() const { return rgb_.data(); }

    // How directions fall on the texels.
    const TexelGrid& grid() const { return grid_; }

    // Linear RGB radiance that arrives from a direction of unit length: that of its texel.
    Color radiance(Vec3 direction) const { return texel(grid_.texel_index(direction.x, direction.y, direction.z)); }

    // The same interpolated between the centres of the four nearest texels: for an eye, which would see their edges.
    Color interpolated_radiance(Vec3 direction) const;

private:
    Color texel(int index) const {
        const float* rgb = texels() + 3 * static_cast<std::ptrdiff_t>(index);
        return {rgb[0], rgb[1], rgb[2]};
    }

    TexelGrid grid_;
    int height_;
    std::vector<float> rgb_;
};
