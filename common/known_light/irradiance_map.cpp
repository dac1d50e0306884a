#include "known_light/irradiance_map.h"

#include <algorithm>
#include <stdexcept>

#include "known_light/texels_on_sphere.h"

namespace bmc {
namespace {

using portable::SineCosine, portable::sincos_turns;

// The cells of the table, 1.4 degrees wide; it holds E at their corners.
constexpr std::size_t columns = 256, rows = 128;

// E(n) is n times the integral of L w dw over the hemisphere around n. The light that a band of texel rows sends from
// one column of cells is a vector for each colour, its integral of L w dw. In the band a hemisphere is an interval of
// columns, so its light is a difference of prefix sums, at the same distance from every n of one latitude.
class HemisphereIntegrals {
public:
    HemisphereIntegrals() : flux_(parts * columns), integrals_(parts * (rows + 1) * columns) {
        for (std::size_t i = 0; i <= rows; ++i) polar_.push_back(sincos_turns(0.5 * static_cast<double>(i) / rows));
        for (std::size_t i = 0; i < columns / 2; ++i)
            distances_.push_back(sincos_turns((static_cast<double>(i) + 0.5) / columns).cosine);
    }

    void add(Color light, Vec3 direction, std::size_t column) {
        double* flux = &flux_[column];
        for (const double value : {light.x, light.y, light.z})
            for (const double axis : {direction.x, direction.y, direction.z}) {
                *flux += value * axis;
                flux += columns;
            }
    }

    // What was added since the last band ended comes from this polar angle.
    void end_band(SineCosine polar) {
        std::size_t reach[rows + 1];  // in columns
        for (std::size_t row = 0; row <= rows; ++row)
            reach[row] = count_above(distances_, cosine_of_half_width(0, polar_[row], polar));
        float prefix[2 * columns + 1] = {};  // from half a turn before the first column to half a turn after the last
        for (std::size_t part = 0; part < parts; ++part) {
            double sum = 0;
            for (std::size_t i = 0; i < 2 * columns; ++i) {
                sum += flux_[part * columns + (i + columns / 2) % columns];
                prefix[i + 1] = static_cast<float>(sum);
            }
            for (std::size_t row = 0; row <= rows; ++row) {
                const float *end = prefix + columns / 2 + reach[row], *begin = prefix + columns / 2 - reach[row];
                float* integral = integrals_.data() + (part * (rows + 1) + row) * columns;
                for (std::size_t i = 0; i < columns; ++i) integral[i] += end[i] - begin[i];
            }
        }
        std::fill(flux_.begin(), flux_.end(), 0.0);
    }

    // E at the corners of the cells, the last column a copy of the first.
    std::vector<float> irradiance() const {
        std::vector<float> rgb;
        for (std::size_t row = 0; row <= rows; ++row)
            for (std::size_t column = 0; column <= columns; ++column) {
                const Vec3 normal =
                    direction_of(polar_[row], sincos_turns(static_cast<double>(column) / columns - 0.5));
                const float* integral = integrals_.data() + row * columns + column % columns;
                for (int channel = 0; channel < 3; ++channel) {
                    double sum = 0;
                    for (const double axis : {normal.x, normal.y, normal.z}) {
                        sum += axis * static_cast<double>(*integral);
                        integral += (rows + 1) * columns;
                    }
                    rgb.push_back(static_cast<float>(sum > 0 ? sum : 0));
                }
            }
        return rgb;
    }

private:
    static constexpr std::size_t parts = 9;  // three axes for each colour

    std::vector<SineCosine> polar_;  // of the normals
    std::vector<double> distances_;  // cosines, from a corner to the middles of the columns on one side
    std::vector<double> flux_;       // [part][column] of the band at hand
    std::vector<float> integrals_;   // [part][row][column]
};

}  // namespace

IrradianceMap::IrradianceMap(const EnvironmentMap& environment) : grid_(columns + 1, rows + 1) {
    const float* const light = environment.texels();
    if (*std::max_element(light, light + 3 * environment.width() * environment.height()) > 1e36f)
        throw std::runtime_error("the environment is too bright to be known: a radiance exceeds 1e36");
    const TexelsOnSphere texels(environment, columns, rows);
    std::vector<SineCosine> azimuths;
    for (int i = 0; i < texels.columns(); ++i) azimuths.push_back(texels.azimuth(i));
    HemisphereIntegrals integrals;
    const int band_rows = 1 + (texels.rows() - 1) / static_cast<int>(rows);
    for (int begin = 0, end = 0; begin < texels.rows(); begin = end) {
        end = std::min(begin + band_rows, texels.rows());
        for (int row = begin; row < end; ++row) {
            const SineCosine polar = texels.polar(row + 0.5);
            const double solid_angle = texels.solid_angle(row);
            for (std::size_t i = 0; i < azimuths.size(); ++i)
                integrals.add(solid_angle * texels(row, static_cast<int>(i)), direction_of(polar, azimuths[i]),
                              i * columns / azimuths.size());
        }
        integrals.end_band(texels.polar(0.5 * (begin + end)));
    }
    rgb_ = integrals.irradiance();
}

Color IrradianceMap::operator()(Vec3 normal) const {
    const double x = grid_.column_coordinate(normal.x, normal.z), y = grid_.row_coordinate(normal.y);
    const std::size_t column = std::min(static_cast<std::size_t>(x), columns - 1);
    const std::size_t row = std::min(static_cast<std::size_t>(y), rows - 1);
    const double right = x - static_cast<double>(column), down = y - static_cast<double>(row);
    const auto corner = [&](std::size_t i, std::size_t j) {
        const float* rgb = &rgb_[3 * ((row + i) * (columns + 1) + column + j)];
        return Color{rgb[0], rgb[1], rgb[2]};
    };
    return (1 - down) * ((1 - right) * corner(0, 0) + right * corner(0, 1)) +
           down * ((1 - right) * corner(1, 0) + right * corner(1, 1));
}
}  // namespace bmc
