#include "scene/prefiltered_environment.h"

#include "scene/solid_texels.h"

namespace {

using portable::pi;
using portable::SineCosine;

// Linear RGB and what an even light of radiance 1 would be in its place: four numbers, which one SIMD instruction
// takes.
struct Sum {
    double rgb1[4] = {};
};

Sum operator+(const Sum& a, const Sum& b) {
    Sum sum;
    for (int i = 0; i < 4; ++i) sum.rgb1[i] = a.rgb1[i] + b.rgb1[i];
    return sum;
}

Sum operator-(const Sum& a, const Sum& b) {
    Sum sum;
    for (int i = 0; i < 4; ++i) sum.rgb1[i] = a.rgb1[i] - b.rgb1[i];
    return sum;
}

Sum operator*(double s, const Sum& a) {
    Sum sum;
    for (int i = 0; i < 4; ++i) sum.rgb1[i] = s * a.rgb1[i];
    return sum;
}

// The light of one row of texels, summed along the azimuth twice: S(x) is the integral from 0 to x of the integral from
// 0 to t of L, in texels, for x from -columns to 2 columns. A cap is an interval t - a to t + a of the row; while t
// goes from one end of a cell to the other, the mean of its light is the growth of S(t + a) - S(t - a) over the width
// of the cell. S is exact between two texels and linear in between: no light moves further than half a texel, and as an
// even light moves with it, means of one are exact.
class RowIntegral {
public:
    explicit RowIntegral(const SolidTexels& texels) : texels_(texels), sums_(3 * size() + 1) {}

    void set_row(int row) {
        const std::size_t n = size();
        Sum& sum = row_sum_ = {};
        for (std::size_t i = 0; i < n; ++i) {
            const Color light = texels_(row, static_cast<int>(i));
            const Sum texel{{light.x, light.y, light.z, 1}};
            sums_[n + i + 1] = sums_[n + i] + sum + 0.5 * texel;
            sum = sum + texel;
        }
        // S(x + columns) = S(x) + S(columns) + x times the sum of the row.
        for (std::size_t i = 0; i <= n; ++i) {
            sums_[2 * n + i] = sums_[n + i] + sums_[2 * n] + static_cast<double>(i) * sum;
            sums_[i] = sums_[n + i] - sums_[2 * n] + static_cast<double>(n - i) * sum;
        }
    }

    const Sum& row_sum() const { return row_sum_; }

    // S(x).
    Sum operator()(double x) const {
        const double t = x + texels_.columns();
        const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(t);
        const Sum* sums = sums_.data() + i;
        return sums[0] + (t - static_cast<double>(i)) * (sums[1] - sums[0]);
    }

private:
    std::size_t size() const { return static_cast<std::size_t>(texels_.columns()); }

    const SolidTexels& texels_;
    Sum row_sum_;
    std::vector<Sum> sums_;
};

// The averages over the caps of one solid angle, in cells two thirds of a radius wide.
class CapAverages {
public:
    CapAverages(double solid_angle, const SolidTexels& texels)
        : texels_(texels),
          radius_cosine_(1 - solid_angle / (2 * pi)),
          reach_(1.05 * std::sqrt(solid_angle / pi)),
          rows_(1 + static_cast<int>(1.5 * pi / std::sqrt(solid_angle / pi))),
          columns_(2 * rows_),
          groups_(std::min(4, 1 + (texels.rows() - 1) / (3 * rows_))),
          light_(static_cast<std::size_t>(rows_ * columns_)) {
        const int latitudes = rows_ * groups_ * group;
        for (int i = 0; i < latitudes; ++i) polar_.push_back(portable::sincos_turns(0.5 * (i + 0.5) / latitudes));
    }

    // half_steps[k] is the cosine of k half texels of azimuth, for k up to half a turn.
    void add_row(int texel_row, const RowIntegral& integral, const std::vector<double>& half_steps) {
        const double angle = (texel_row + 0.5) / texels_.rows(), reach = reach_ / pi;  // in half turns
        const int first = std::max(0, static_cast<int>((angle - reach) * rows_));
        const int last = std::min(rows_ - 1, static_cast<int>((angle + reach) * rows_));
        const SineCosine polar = texels_.polar(texel_row + 0.5);
        const double solid_angle = texels_.solid_angle(texel_row);
        for (int i = groups_ * first; i < groups_ * (last + 1); ++i) {
            double weight = 0, half_width = 0;  // by the solid angle of the latitudes
            for (int k = group * i; k < group * (i + 1); ++k) {
                const SineCosine centre = polar_[static_cast<std::size_t>(k)];
                weight += centre.sine;
                half_width += centre.sine * half_interval(centre, polar, half_steps);
            }
            if (half_width > 0) add_intervals(i / groups_, half_width / weight, weight * solid_angle, integral);
        }
    }

    // A table as TexelGrid reads it: the last row and column, which only u = 1 and v = 1 meet, repeat their neighbours.
    int table_columns() const { return columns_ + 1; }
    int table_rows() const { return rows_ + 1; }
    std::vector<float> rgb(const Sum& everywhere) const {
        std::vector<float> rgb;
        for (int i = 0; i <= rows_; ++i)
            for (int j = 0; j <= columns_; ++j) {
                const std::size_t row = static_cast<std::size_t>(std::min(i, rows_ - 1));
                const std::size_t column = static_cast<std::size_t>(std::min(j, columns_ - 1));
                const double* light = light_[row * static_cast<std::size_t>(columns_) + column].rgb1;
                for (int k = 0; k < 3; ++k) rgb.push_back(static_cast<float>(light[k] / light[3] + everywhere.rgb1[k]));
            }
        rgb.resize(rgb.size() + EnvironmentMap::beyond);
        return rgb;
    }

private:
    // The caps' centres in a row of cells have latitudes in groups, up to four of them; a group shares the mean of the
    // widths of its caps.
    static constexpr int group = 3;

    // Half the interval of a row of texels that a cap covers, in texels.
    double half_interval(SineCosine centre, SineCosine texel, const std::vector<double>& half_steps) const {
        const double cosine = cap_azimuth(radius_cosine_, centre, texel);
        if (cosine >= 1) return 0;
        if (cosine <= -1) return 0.5 * texels_.columns();
        const std::size_t k = count_above(half_steps, cosine);
        const double before = half_steps[k - 1];
        return 0.5 * (static_cast<double>(k - 1) + (before - cosine) / (before - half_steps[k]));
    }

    void add_intervals(int row, double half_width, double solid_angle, const RowIntegral& integral) {
        const double cell = static_cast<double>(texels_.columns()) / columns_;
        Sum* light = &light_[static_cast<std::size_t>(row * columns_)];
        Sum before = integral(half_width) - integral(-half_width);
        for (int column = 0; column < columns_; ++column) {
            const double end = (column + 1) * cell;
            const Sum after = integral(end + half_width) - integral(end - half_width);
            light[column] = light[column] + solid_angle / cell * (after - before);
            before = after;
        }
    }

    const SolidTexels& texels_;
    double radius_cosine_, reach_;
    int rows_, columns_, groups_;
    std::vector<Sum> light_;         // times solid angle
    std::vector<SineCosine> polar_;  // of the latitudes
};

}  // namespace

PrefilteredEnvironment::PrefilteredEnvironment(const EnvironmentMap& map)
    : sun_(map),
      without_sun_(sun_.empty() ? std::nullopt : std::optional(sun_.sky())),
      sky_(without_sun_ ? *without_sun_ : map),
      irradiance_(sky_) {
    if (!sun_.empty()) sun_irradiance_.emplace(sun_.alone());
    const SolidTexels texels(sky_, 256, 128);
    std::vector<CapAverages> levels;
    for (double solid_angle = pi; 2 * std::sqrt(solid_angle / pi) >= 10 * pi / texels.rows(); solid_angle /= 4) {
        levels.emplace_back(solid_angle, texels);
        tables_.push_back({solid_angle, levels.back().table_columns(), levels.back().table_rows(), nullptr});
    }
    std::vector<double> half_steps;
    for (int i = 0; i <= texels.columns(); ++i)
        half_steps.push_back(portable::sincos_turns(0.5 * i / texels.columns()).cosine);
    RowIntegral integral(texels);
    Sum mean;
    for (int row = 0; row < texels.rows(); ++row) {
        integral.set_row(row);
        mean = mean + texels.solid_angle(row) / (4 * pi) * integral.row_sum();
        for (CapAverages& level : levels) level.add_row(row, integral, half_steps);
    }
    for (std::size_t i = 0; i < levels.size(); ++i) {
        caps_.push_back(levels[i].rgb(1e-6 * mean));
        tables_[i].rgb = caps_.back().data();
    }
    tables_.push_back({texels.solid_angle(texels.rows() / 2), sky_.width(), sky_.height(), sky_.texels()});
}

const LightTable& PrefilteredEnvironment::table(double solid_angle) const {
    std::size_t i = 0;
    while (i + 1 < tables_.size() && solid_angle * solid_angle < tables_[i].solid_angle * tables_[i + 1].solid_angle)
        ++i;
    return tables_[i];
}
