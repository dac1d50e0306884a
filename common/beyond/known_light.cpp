#include "beyond/known_light.h"

#include "base/progress.h"

namespace bmc::beyond {
using portable::pi;

constexpr std::size_t lookups = 32;  // per mean

// Directions spread evenly over the inner three quarters of a cap around the up axis. The smaller caps around them
// reach to the cap's edge.
static std::vector<Vec3> cap_directions(double solid_angle) {
    const double depth = 0.75 * solid_angle / (2 * pi);  // 1 minus the cosine of the radius
    std::vector<Vec3> directions;
    for (const Vec3& direction : fibonacci_directions(lookups)) {
        const double cosine = 1 - depth * (1 - direction.y);
        const double scale = std::sqrt((1 - cosine * cosine) / (1 - direction.y * direction.y));
        directions.push_back({scale * direction.x, cosine, scale * direction.z});
    }
    return directions;
}

constexpr int light_columns = 96, light_rows = 48;  // of the cells that light is gathered in

// The part, of `parts` equal ones, that texel i of n lies in.
static std::size_t part_with(int i, int n, int parts) { return static_cast<std::size_t>(std::int64_t{i} * parts / n); }

// The integral of L omega d omega for each cell and each colour, over the texels whose R + G + B exceeds `least`.
static std::vector<Vec3> fluxes(const EnvironmentMap& environment, double least) {
    const TexelsOnSphere texels(environment, light_columns, light_rows);
    std::vector<portable::SineCosine> azimuths;
    for (int i = 0; i < texels.columns; ++i) azimuths.push_back(texels.azimuth(i + 0.5));
    std::vector<Vec3> fluxes(3 * light_columns * light_rows);
    for (int row = 0; row < texels.rows; ++row) {
        const portable::SineCosine polar = texels.polar(row + 0.5);
        const double solid_angle = texels.solid_angle(row);
        for (int column = 0; column < texels.columns; ++column) {
            if (!(brightness(texels(row, column)) > least)) continue;
            const Colour light = solid_angle * texels(row, column);
            const Vec3 direction = direction_of(polar, azimuths[static_cast<std::size_t>(column)]);
            Vec3* flux = &fluxes[3 * (part_with(row, texels.rows, light_rows) * light_columns +
                                      part_with(column, texels.columns, light_columns))];
            for (const double colour : {light.x, light.y, light.z}) *flux++ += colour * direction;
        }
    }
    return fluxes;
}

// E(n) is the sum of max(n . F, 0) over the fluxes F, at the corners of the table's cells. Only cells of light that are
// cut by n's horizon are underestimated.
static EnvironmentMap irradiance_table(const std::vector<Vec3>& flux, int rows, std::size_t threads) {
    constexpr int most_columns = 256;
    const int columns = 2 * rows;
    EnvironmentMap table(columns + 1, rows + 1);
    for_each_row(rows + 1, threads, [&](int row) {
        const portable::SineCosine polar = portable::sincos_turns(0.5 * row / rows);
        double x[most_columns + 1], z[most_columns + 1], sums[3][most_columns + 1] = {};
        for (int i = 0; i <= columns; ++i) {
            const Vec3 normal = direction_of(polar, portable::sincos_turns(static_cast<double>(i) / columns - 0.5));
            x[i] = normal.x;
            z[i] = normal.z;
        }
        for (std::size_t f = 0; f < flux.size(); ++f) {
            if (dot(flux[f], flux[f]) == 0) continue;
            const double vertical = polar.cosine * flux[f].y;
            double* sum = sums[f % 3];
            for (int i = 0; i <= columns; ++i) {
                const double e = x[i] * flux[f].x + vertical + z[i] * flux[f].z;
                sum[i] += e > 0 ? e : 0;
            }
        }
        for (int i = 0; i <= columns; ++i) table.set(i, row, {sums[0][i], sums[1][i], sums[2][i]});
    });
    return table;
}

// A cap is made of caps of a quarter of its size, the smallest one of texels: each texel of the table is the mean of
// lookups in the finer table. Only u = 1 and v = 1 meet the last row and column, which repeat their neighbours.
static EnvironmentMap average(const EnvironmentMap& finer, double solid_angle, Colour everywhere, std::size_t threads) {
    const int rows = 1 + static_cast<int>(1.5 * pi / std::sqrt(solid_angle / pi)), columns = 2 * rows;
    const std::vector<Vec3> local = cap_directions(solid_angle);
    EnvironmentMap means(columns + 1, rows + 1);
    for_each_row(rows + 1, threads, [&](int y) {
        const portable::SineCosine polar = portable::sincos_turns(0.5 * (std::min(y, rows - 1) + 0.5) / rows);
        for (int x = 0; x <= columns; ++x) {
            const auto azimuth = portable::sincos_turns((std::min(x, columns - 1) + 0.5) / columns - 0.5);
            const Frame frame(direction_of(polar, azimuth));
            int texels[lookups];
            for (std::size_t i = 0; i < lookups; ++i) texels[i] = finer.index(frame.to_world(local[i]));
            Colour sum;
            for (const int texel : texels) sum += finer.colour(texel);
            means.set(x, y, 1.0 / lookups * sum + everywhere);
        }
    });
    return means;
}

PrefilteredEnvironment::PrefilteredEnvironment(const EnvironmentMap& map, std::size_t threads)
    : sun(map),
      tables_{{0, sun.sky(map)}},
      sky_irradiance_(irradiance_table(fluxes(*tables_[0].means, 0), 64, threads)),
      sun_irradiance_(irradiance_table(fluxes(map, sun.least()), sun.empty() ? 1 : 128, threads)) {
    const TexelsOnSphere texels(*tables_[0].means, 256, 128);
    tables_[0].solid_angle = texels.solid_angle(texels.rows / 2);
    Colour everywhere = 1e-6 / (2 * pi) * (sky_irradiance({0, 1, 0}) + sky_irradiance({0, -1, 0}));
    double solid_angle = pi;
    while (std::sqrt(solid_angle / pi) >= 10 * pi / texels.rows) solid_angle /= 4;
    for (; solid_angle <= pi; solid_angle *= 4, everywhere = {}) {  // larger caps have it from the smaller ones
        EnvironmentMap means = average(*tables_.back().means, solid_angle, everywhere, threads);
        tables_.push_back({solid_angle, std::make_shared<const EnvironmentMap>(std::move(means))});
    }
}

const EnvironmentMap& PrefilteredEnvironment::means(double solid_angle) const {
    std::size_t i = 0;
    while (i + 1 < tables_.size() && solid_angle * solid_angle >= tables_[i].solid_angle * tables_[i + 1].solid_angle)
        ++i;
    return *tables_[i].means;
}

SampleCounts share_out(const Sun& sun, Colour by_sky, Colour by_sun, std::size_t samples) {
    if (brightness(by_sun) == 0) return {samples, 0};
    const auto part_of = [](double deviation) { return std::sqrt(deviation * std::sqrt(deviation)); };
    const double to_sun = part_of(0.4 * std::sqrt(std::sqrt(sun.spread())) * brightness(by_sun));
    const double wanted = to_sun / (to_sun + part_of(brightness(by_sky))) * static_cast<double>(samples);
    const std::size_t rays = std::max<std::size_t>(static_cast<std::size_t>(wanted + 0.5), 1);
    return {samples > rays ? samples - rays : 1, rays};
}

// The fraction of each colour of the sky's light that passes the other object. That covers nobody's whole sky: where it
// stops all n rays, about 1 / (n + 1) of the light passes between them.
static Colour visible_sky(const EnvironmentMap& means, const Hit& hit, const QuadratureRule& rule, const Frame& frame) {
    std::vector<int> all(rule.size()), visible(rule.size());  // texels; the black one in the shadow
    for (std::size_t i = 0; i < rule.size(); ++i) {
        const Vec3 direction = frame.to_world(rule.directions[i]);
        all[i] = means.index(direction);
        visible[i] = !is_shadowed(sphere_scene, hit, direction) * all[i];
    }
    if (all == visible) return {1, 1, 1};
    RatioEstimator sky;
    for (std::size_t i = 0; i < rule.size(); ++i) {
        sky.all += rule.weights[i] * means.colour(all[i]);
        sky.visible += rule.weights[i] * means.colour(visible[i]);
    }
    const Colour fraction = sky.fraction(), least = 1 / static_cast<double>(rule.size() + 1) * Colour{1, 1, 1};
    return brightness(fraction) > 0 ? fraction : least;
}

// The sky's rules: of all n samples, and where there is a sun, of fewer. The sun's part grows by a quarter from one to
// the next, or the sky's shrinks by a quarter, whichever is the smaller step. The time to make a rule grows like n^3:
// of many samples, the largest leaves out three quarters of the sun's share, even where the sun has set, and all steps
// are a quarter.
static std::vector<PixelRules> sky_rules(const Sun& sun, RenderSettings settings) {
    const std::size_t all = settings.samples;
    const bool many = all > 200;
    std::size_t& n = settings.samples;
    if (many) n = static_cast<std::size_t>((1 - 0.75 * sun.share()) * static_cast<double>(all));
    std::vector<PixelRules> rules{PixelRules(settings)};
    while (!sun.empty() && n > 1) {
        n -= 1 + (many ? n - 2 : std::min(all - n, n - 2)) / 4;
        rules.emplace_back(settings);
    }
    return rules;
}

Shader light_shader(const EnvironmentLight& any_light, RenderSettings settings) {
    if (!any_light.averages) return environment_shader(any_light.environment, PixelRules(settings));
    const std::shared_ptr<const PrefilteredEnvironment> light = any_light.averages;
    return [=, rules = sky_rules(light->sun, settings)](const Hit& hit, int x, int y) {
        const Colour by_sky = light->sky_irradiance(hit.normal), by_sun = light->sun_irradiance(hit.normal);
        const SampleCounts samples = share_out(light->sun, by_sky, by_sun, settings.samples);
        Random random = pixel_stream(settings, x, y);
        std::size_t size = 0;
        while (rules[size].settings.samples > samples.sky) ++size;
        const OrientedRule sky = rules[size].rule_for(hit.normal, random);
        // A little less than a sample's part of the hemisphere: caps that are too large are biased.
        const EnvironmentMap& means = light->means(1.7 * pi / static_cast<double>(sky.rule->size()));
        Colour irradiance = by_sky * visible_sky(means, hit, *sky.rule, sky.frame);
        if (samples.sun > 0) {
            const std::size_t rays = std::max(settings.samples, sky.rule->size() + 1) - sky.rule->size();
            irradiance += by_sun * sample_sun(sphere_scene, light->sun, hit, rays, random).fraction();
        }
        return 1 / pi * (hit.albedo * irradiance);
    };
}
}  // namespace bmc::beyond
