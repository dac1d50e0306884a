// Light from infinitely far away: a map of radiance over all directions. A map of W x H texels has rows of constant
// elevation, row 0 around +y, and columns of constant azimuth, -z in the middle and +x to the right of it. A direction
// meets column floor(u (W - 1)) and row floor(v (H - 1)), where u = (1 + atan2(x, -z) / pi) / 2 and v = acos(y) / pi.
// So it meets the last column or row only if u or v is 1.
#pragma once

#include "numerics/vec3.h"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace bmc {
// The texels of a map of so many columns and rows, apart from their radiance.
class TexelGrid {
public:
    TexelGrid(int columns, int rows) : width_(columns), height_(rows) {}

    // Row * width_ + column of the texel that a direction of unit length sees, in the precision of its components.
    // Anything else, nan included, still gives a texel of the map.
    //
    // This runs for every secondary ray. It is arithmetic without a branch, which a compiler can turn into SIMD. The
    // polynomials err by at most 2.3e-8, 4e-6 of a texel in a map 1024 wide. Rounding in single precision moves a
    // texel's border by 3e-5; beyond 2^24 texels the index itself is rounded.
    template <class Real>
    int texel_index(Real x, Real y, Real z) const {
        const int i = static_cast<int>(row_coordinate(y)), j = static_cast<int>(column_coordinate(x, z));
        return (i < height_ ? i : height_ - 1) * width_ + (j < width_ ? j : width_ - 1);
    }

    // v (H - 1) and u (W - 1), with their fractions.
    template <class Real>
    Real row_coordinate(Real y) const {
        return clamp(arccosine(y) * Real(1 / portable::pi) * Real(height_ - 1), Real(height_ - 1));
    }
    template <class Real>
    Real column_coordinate(Real x, Real z) const {
        return clamp((Real(0.5) + azimuth(x, z) * Real(0.5 / portable::pi)) * Real(width_ - 1), Real(width_ - 1));
    }

    int width() const { return width_; }
    int height() const { return height_; }

private:
    // To [0, last]; the order of the comparisons sends nan to 0.
    template <class Real>
    static Real clamp(Real t, Real last) {
        const Real not_negative = t > 0 ? t : 0;
        return not_negative < last ? not_negative : last;
    }

    // Abramowitz & Stegun, Handbook of Mathematical Functions (1964), 4.4.46: acos(a) = sqrt(1 - a) P7(a) on [0, 1],
    // and acos(-a) = pi - acos(a).
    template <class Real>
    static Real arccosine(Real y) {
        constexpr double c[] = {1.5707963050, -0.2145988016, 0.0889789874, -0.0501743046,
                                0.0308918810, -0.0170881256, 0.0066700901, -0.0012624911};
        const Real a = std::fabs(y);
        const Real from_pole = std::sqrt(a < 1 ? 1 - a : 0) * portable::polynomial(c, a);
        return y < 0 ? Real(portable::pi) - from_pole : from_pole;
    }

    // atan2(x, -z) by Abramowitz & Stegun 4.4.49, atan(t) = t P8(t^2) on [0, 1], and the symmetries of the octants.
    // The smallest normal number in the denominator gives straight up and straight down the azimuth 0.
    template <class Real>
    static Real azimuth(Real x, Real z) {
        constexpr double c[] = {1.0000000000,  -0.3333314528, 0.1999355085,  -0.1420889944, 0.1065626393,
                                -0.0752896400, 0.0429096138,  -0.0161657367, 0.0028662257};
        constexpr Real smallest = std::numeric_limits<Real>::min();
        const Real across = std::fabs(x), along = std::fabs(z);
        const Real longer = across > along ? across : along;
        const Real t = (across > along ? along : across) / (longer > smallest ? longer : smallest);
        const Real octant = t * portable::polynomial(c, t * t);
        const Real quadrant = across > along ? Real(portable::pi / 2) - octant : octant;
        const Real half = z > 0 ? Real(portable::pi) - quadrant : quadrant;
        return x < 0 ? -half : half;
    }

    int width_, height_;
};

class EnvironmentMap {
public:
    static constexpr int max_texels = 1 << 26;

    // rgb: linear RGB radiance, interleaved, height rows of width texels, row 0 at the top; finite and >= 0. Throws
    // std::invalid_argument for anything else, also for more than max_texels.
    EnvironmentMap(int width, int height, std::vector<float> rgb);

    // A black map, and its rows for whoever paints it: finite radiance >= 0.
    EnvironmentMap(int width, int height);
    float* row(int y) { return &rgb_[3 * static_cast<std::size_t>(y) * static_cast<std::size_t>(width())]; }
    void set(int x, int y, Color radiance) {
        float* rgb = row(y) + 3 * std::ptrdiff_t{x};
        for (const double colour : {radiance.x, radiance.y, radiance.z}) *rgb++ = static_cast<float>(colour);
    }

    std::string name = "the environment";  // for messages

    int width() const { return grid_.width(); }
    int height() const { return grid_.height(); }

    // Texel i is at 3 i, 3 i + 1, 3 i + 2. After the last one stand `padding` zeros: a black texel, for loops that take
    // four floats at a time.
    static constexpr std::size_t padding = 4;
    const float* texels() const { return rgb_.data(); }
    Color texel(int i) const {
        const float* rgb = texels() + 3 * std::ptrdiff_t{i};
        return {rgb[0], rgb[1], rgb[2]};
    }

    // How directions fall on the texels.
    const TexelGrid& grid() const { return grid_; }

    // Linear RGB radiance that arrives from a direction of unit length, a Vec3 or a Direction: that of its texel.
    template <class Vector = Vec3>
    Color radiance(Vector direction) const {
        return texel(grid_.texel_index(direction.x, direction.y, direction.z));
    }

    // The same interpolated between the centres of the four nearest texels: for an eye, which would see their edges.
    Color interpolated_radiance(Vec3 direction) const;

private:
    TexelGrid grid_;
    std::vector<float> rgb_;
};
}  // namespace bmc
