#include "known_light/known_light.h"

namespace bmc {
std::vector<Lamp> cells_of_light(const EnvironmentMap& map, double most, int rows) {
    const TexelsOnSphere texels(map, 2 * rows, rows);
    const auto part = [](int i, int n, int parts) { return static_cast<int>(std::int64_t{i} * parts / n); };
    std::vector<portable::SineCosine> azimuths;
    for (int column = 0; column < texels.columns; ++column) azimuths.push_back(texels.azimuth(column + 0.5));
    std::vector<Lamp> cells(static_cast<std::size_t>(2 * rows * rows)), lit;
    for (int row = 0; row < texels.rows; ++row) {
        const portable::SineCosine polar = texels.polar(row + 0.5);
        const double solid_angle = texels.solid_angle(row);
        for (int column = 0; column < texels.columns; ++column) {
            const Colour radiance = texels(row, column), light = solid_angle * radiance;
            if (channel_sum(radiance) > most) continue;
            const int cell_row = part(row, texels.rows, rows), cell_column = part(column, texels.columns, 2 * rows);
            Lamp& cell = cells[static_cast<std::size_t>(2 * rows * cell_row + cell_column)];
            cell.direction += channel_sum(light) * direction_of(polar, azimuths[std::size_t(column)]);
            cell.light += light;
        }
    }
    for (const auto& [direction, light] : cells)
        if (channel_sum(light) > 0) lit.push_back({1 / channel_sum(light) * direction, light});
    return lit;
}

// Of two texels (row, column), whether the bits of row and column in turns are the smaller number for a (Morton, "A
// computer oriented geodetic data base", IBM 1966). The highest bit that differs decides.
static bool in_order(std::pair<int, int> a, std::pair<int, int> b) {
    const int rows = a.first ^ b.first, columns = a.second ^ b.second;
    return rows < columns && rows < (rows ^ columns) ? a.second < b.second : a.first < b.first;
}

std::vector<Lamp> points_of_light(const EnvironmentMap& map, double least, std::size_t count) {
    const TexelsOnSphere texels(map, 1000, 500);  // of which a point in the middle is near enough
    std::vector<std::pair<int, int>> bright;
    double all = 0, passed = 0;  // light; points
    for (int row = 0; row < texels.rows; ++row)
        for (int column = 0; column < texels.columns; ++column) {
            if (!(channel_sum(texels(row, column)) > least)) continue;
            bright.emplace_back(row, column);
            all += texels.solid_angle(row) * channel_sum(texels(row, column));
        }
    std::sort(bright.begin(), bright.end(), in_order);
    const double share = all / static_cast<double>(count);  // the light of a point
    std::vector<Lamp> points;
    for (const auto& [row, column] : bright) {
        const Colour radiance = texels(row, column);
        const double here = texels.solid_angle(row) * channel_sum(radiance) / share;  // points, from left to right
        while (true) {
            const double across = (static_cast<double>(points.size()) + 0.5 - passed) / here;
            if (!(across < 1)) break;  // nor nan
            points.push_back({direction_of(texels.polar(row + 0.5), texels.azimuth(column + across)),
                              share / channel_sum(radiance) * radiance});
        }
        passed += here;
    }
    return points;
}

EnvironmentMap light_around(const std::vector<Lamp>& lamps, double cosine, int rows, double place,
                            std::size_t threads) {
    EnvironmentMap table(2 * rows + 1, rows + 1);
    const TexelsOnSphere places(table);
    for_each_row(table.height, threads, [&](int y) {
        const portable::SineCosine polar = places.polar(y + place);
        std::vector<double> x(static_cast<std::size_t>(table.width)), z(x), red(x), green(x), blue(x);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const Vec3 d = direction_of(polar, places.azimuth(static_cast<double>(i) + place));
            x[i] = d.x;
            z[i] = d.z;
        }
        for (const auto& [direction, light] : lamps) {
            const double up = direction.y * polar.cosine - cosine,
                         along = direction.x * direction.x + direction.z * direction.z;
            if (up + std::fabs(polar.sine) * std::sqrt(along) <= 0) continue;  // no d of this row is near it
            for (std::size_t i = 0; i < x.size(); ++i) {
                const double height = x[i] * direction.x + z[i] * direction.z + up, tent = height > 0 ? height : 0;
                red[i] += tent * light.x;
                green[i] += tent * light.y;
                blue[i] += tent * light.z;
            }
        }
        for (std::size_t i = 0; i < x.size(); ++i) table.set(static_cast<int>(i), y, {red[i], green[i], blue[i]});
    });
    return table;
}

Colour fraction(Colour visible, Colour all) {
    const auto of = [](double part, double whole) { return whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 1; };
    return {of(visible.x, all.x), of(visible.y, all.y), of(visible.z, all.z)};
}

void Arriving::add(const Hit& hit, const Lamp& lamp) {
    const Colour light = std::max(0.0, dot(hit.normal, lamp.direction)) * lamp.light;
    all += light;
    if (!is_shadowed(sphere_scene, hit, lamp.direction)) visible += light;
}

// The fraction of the sky's light that passes the other object, for each colour: a picture of the light around the
// samples over the same without that object. If that stops all n rays, about 1 / (n + 1) of the light passes between.
static Colour visible_sky(const EnvironmentMap& cones, const Hit& hit, const OrientedRule& oriented) {
    static const Scene empty{};  // objects without extent shadow nothing
    const auto reflected = [&](const Scene& scene) {
        return reflected_radiance(scene, cones, hit, *oriented.rule, oriented.frame);
    };
    const Colour passes = fraction(reflected(sphere_scene), reflected(empty));
    return channel_sum(passes) > 0 ? passes : 1 / static_cast<double>(oriented.rule->size() + 1) * Colour{1, 1, 1};
}

// The same of the sun's light, by n rays at equal distances in the list; u in [0, 1) shifts them.
static Colour visible_sun(const std::vector<Lamp>& sun, const Hit& hit, double n, double u) {
    const double last = static_cast<double>(sun.size()) - 1, distance = (last + 1) / n;
    Arriving sum;
    for (double j = u; j < n; ++j) sum.add(hit, sun[static_cast<std::size_t>(std::min(j * distance, last))]);
    return fraction(sum.visible, sum.all);
}

// E(n) is a sum over 2048 lamps, cells or points, whatever the samples. The wider the sun, the more pixels lie in its
// penumbra, where v varies: the mean square deviation grows in proportion to the sun's size.
KnownLight known_light(const EnvironmentMap& map, std::size_t samples, std::size_t threads) {
    const double bright = 10 * mean_over_directions(map, channel_sum), n = static_cast<double>(samples);
    const int rows = std::max(48, static_cast<int>(4 * std::sqrt(n)));  // eight to the width of a cone
    const std::vector<Lamp> sun = points_of_light(map, bright, 2048);
    Vec3 mean;
    for (const Lamp& point : sun) mean += 1.0 / 2048 * point.direction;
    const double size = std::sqrt(std::max(1e-12, 1 - dot(mean, mean)));
    return {sun, light_around(cells_of_light(map, bright, 32), 0, 96, 0, threads), light_around(sun, 0, 96, 0, threads),
            light_around(cells_of_light(map, bright, rows), 1 - 2 / n, rows, 0.5, threads), 0.5 * std::sqrt(size)};
}

// A pixel's rays are shared out in proportion to E(n) times the deviation of v (Neyman, "On the two different aspects
// of the representative method", Journal of the Royal Statistical Society 97(4), 1934). The sky has rules of a quarter,
// three eighths, ..., all of the samples: a pixel takes as many eighths as its share has, and gives the rest to the
// sun.
Shader known_light_shader(const KnownLight& light, RenderSettings settings) {
    const std::size_t samples = settings.samples;
    std::vector<PixelRules> rules;  // the largest first
    for (std::size_t eighths = 8; eighths >= (light.sun.empty() ? 8 : 2); --eighths) {
        settings.samples = std::max<std::size_t>(1, samples * eighths / 8);
        rules.emplace_back(settings);
    }
    return [&light, rules, samples](const Hit& hit, int x, int y) {
        const Colour sky = light.sky_irradiance.interpolated(hit.normal),
                     sun = light.sun_irradiance.interpolated(hit.normal);
        const double sky_part = channel_sum(sky), sun_part = light.sun_deviation * channel_sum(sun);
        const int eighths = sun_part > 0 ? std::max(2, static_cast<int>(8 * sky_part / (sky_part + sun_part))) : 8;
        const PixelRules& chosen = rules[static_cast<std::size_t>(8 - eighths)];
        Random random = pixel_stream(chosen.settings, x, y);
        const OrientedRule oriented = chosen.rule_for(hit.normal, random);
        Colour irradiance = sky * visible_sky(light.sky_cones, hit, oriented);
        if (sun_part > 0) {
            const double rays =
                std::max(1.0, static_cast<double>(samples) - static_cast<double>(oriented.rule->size()));
            irradiance += sun * visible_sun(light.sun, hit, rays, random.uniform());
        }
        return 1 / portable::pi * (hit.albedo * irradiance);
    };
}
}  // namespace bmc
