#include "scene/known_light.h"

#include "light/texels_on_sphere.h"

namespace bmc {
using portable::pi;

std::vector<Lamp> cells_of_light(const EnvironmentMap& map, double most, int rows) {
    const TexelsOnSphere texels(map, 2 * rows, rows);
    const auto part = [](int i, int n, int parts) { return static_cast<std::size_t>(std::int64_t{i} * parts / n); };
    std::vector<portable::SineCosine> azimuths;
    for (int column = 0; column < texels.columns; ++column) azimuths.push_back(texels.azimuth(column + 0.5));
    std::vector<Lamp> cells(static_cast<std::size_t>(2 * rows * rows)), lit;
    for (int row = 0; row < texels.rows; ++row) {
        const portable::SineCosine polar = texels.polar(row + 0.5);
        const double solid_angle = texels.solid_angle(row);
        for (int column = 0; column < texels.columns; ++column) {
            const Colour radiance = texels(row, column), light = solid_angle * radiance;
            if (brightness(radiance) > most) continue;
            Lamp& cell =
                cells[part(row, texels.rows, rows) * part(2, 1, rows) + part(column, texels.columns, 2 * rows)];
            cell.direction += brightness(light) * direction_of(polar, azimuths[std::size_t(column)]);
            cell.light += light;
        }
    }
    for (const auto& [direction, light] : cells)
        if (brightness(light) > 0) lit.push_back({1 / brightness(light) * direction, light});
    return lit;
}

// Of two texels (row, column), whether the bits of row and column in turns are the smaller number for a (Morton, "A
// computer oriented geodetic data base", IBM 1966). The highest bit that differs decides.
static bool in_order(std::pair<int, int> a, std::pair<int, int> b) {
    const int rows = a.first ^ b.first, columns = a.second ^ b.second;
    return rows < columns && rows < (rows ^ columns) ? a.second < b.second : a.first < b.first;
}

std::vector<Lamp> points_of_light(const EnvironmentMap& map, double least, std::size_t count) {
    const TexelsOnSphere texels(map);
    std::vector<std::pair<int, int>> bright;
    double all = 0, passed = 0;  // light; points
    for (int row = 0; row < texels.rows; ++row)
        for (int column = 0; column < texels.columns; ++column) {
            if (!(brightness(texels(row, column)) > least)) continue;
            bright.emplace_back(row, column);
            all += texels.solid_angle(row) * brightness(texels(row, column));
        }
    std::sort(bright.begin(), bright.end(), in_order);
    std::vector<Lamp> points;
    Random random(0, 0);
    for (const auto& [row, column] : bright) {
        const double b = brightness(texels(row, column)), point = all / static_cast<double>(count);
        const double here = texels.solid_angle(row) * b / point;  // so many points; they pass from left to right
        for (double across; across = (static_cast<double>(points.size()) + 0.5 - passed) / here, across < 1;) {
            const double top = texels.polar(row).cosine, bottom = texels.polar(row + 1).cosine;
            const double cosine = top + random.uniform() * (bottom - top);
            const portable::SineCosine polar{std::sqrt((1 - cosine) * (1 + cosine)), cosine};
            points.push_back({direction_of(polar, texels.azimuth(column + across)), point / b * texels(row, column)});
        }
        passed += here;
    }
    return points;
}

EnvironmentMap light_around(const std::vector<Lamp>& lamps, double cosine, int rows, double place,
                            std::size_t threads) {
    EnvironmentMap table(2 * rows + 1, rows + 1);
    for_each_row(table.height, threads, [&](int y) {
        const portable::SineCosine polar = portable::sincos_turns(0.5 * (y + place) / rows);
        std::vector<double> x(static_cast<std::size_t>(table.width)), z(x), red(x), green(x), blue(x);
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double turns = 0.5 * (static_cast<double>(i) + place) / rows - 0.5;
            const Vec3 d = direction_of(polar, portable::sincos_turns(turns));
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

// The fraction of each colour of the sky's light that passes the other object. That covers nobody's whole sky: where it
// stops all n rays, about 1 / (n + 1) of the light passes between them. The loops are as in reflected_radiance.
static Colour visible_sky(const EnvironmentMap& around, const Hit& hit, const QuadratureRule& rule,
                          const Frame& frame) {
    std::vector<int> all(rule.size()), visible(rule.size());
    for (std::size_t i = 0; i < rule.size(); ++i) {
        const Vec3 direction = frame.to_world(rule.directions[i]);
        all[i] = around.index(direction);
        visible[i] = !is_shadowed(sphere_scene, hit, direction) * all[i];
    }
    if (all == visible) return {1, 1, 1};
    Colour sum, visible_sum;
    for (std::size_t i = 0; i < rule.size(); ++i) {
        sum += rule.weights[i] * around.colour(all[i]);
        visible_sum += rule.weights[i] * around.colour(visible[i]);
    }
    const Colour passes = fraction(visible_sum, sum),
                 least = 1 / static_cast<double>(rule.size() + 1) * Colour{1, 1, 1};
    return brightness(passes) > 0 ? passes : least;
}

// The same of the sun's light, by n rays at equal distances in the list; u in [0, 1) shifts them.
static Colour visible_sun(const std::vector<Lamp>& sun, const Hit& hit, std::size_t n, double u) {
    const double distance = static_cast<double>(sun.size()) / static_cast<double>(n);
    Colour sum, visible_sum;
    for (std::size_t j = 0; j < n; ++j) {
        const auto place = static_cast<std::size_t>((static_cast<double>(j) + u) * distance);
        const auto& [direction, light] = sun[std::min(place, sun.size() - 1)];
        const Colour arriving = std::max(0.0, dot(hit.normal, direction)) * light;
        sum += arriving;
        if (!is_shadowed(sphere_scene, hit, direction)) visible_sum += arriving;
    }
    return fraction(visible_sum, sum);
}

// A pixel's rays are shared out in proportion to E(n) times the deviation of v (Neyman, "On the two different aspects
// of the representative method", Journal of the Royal Statistical Society 97(4), 1934). The sky has rules of a quarter,
// three eighths, ..., all of the samples: a pixel takes one of at most its share, and gives the rest to the sun. The
// deviation is 1 for the sky, and less for a smaller sun, as fewer pixels see an edge of a shadow cross it; the shorter
// the mean of its directions, the larger it is. E(n) needs no more points or cells for more samples.
Shader known_light_shader(const EnvironmentMap& map, RenderSettings settings) {
    const double bright = 10 * mean_over_directions(map, brightness), samples = static_cast<double>(settings.samples);
    const int rows = std::max(48, static_cast<int>(4 * std::sqrt(samples)));  // eight to the width of a cone
    const std::vector<Lamp> sky = cells_of_light(map, bright, rows);
    const std::vector<Lamp> sun = points_of_light(map, bright, 16 * settings.samples);
    const std::vector<Lamp> fewer = points_of_light(map, bright, std::min<std::size_t>(16 * settings.samples, 2048));
    const EnvironmentMap by_sky = light_around(cells_of_light(map, bright, 48), 0, 48, 0, settings.threads);
    const EnvironmentMap by_sun = light_around(fewer, 0, 128, 0, settings.threads);
    const EnvironmentMap around = light_around(sky, 1 - 2 / samples, rows, 0.5, settings.threads);
    Vec3 mean;
    for (const Lamp& point : sun) mean += 1 / static_cast<double>(sun.size()) * point.direction;
    const double deviation = 0.4 * std::sqrt(std::sqrt(std::sqrt(std::max(1 - dot(mean, mean), 1e-12))));
    std::vector<PixelRules> rules;  // the largest first
    for (std::size_t all = settings.samples, eighths = 8; eighths >= (sun.empty() ? 8 : 2); --eighths) {
        settings.samples = std::max<std::size_t>(1, all * eighths / 8);
        rules.emplace_back(settings);
    }
    return [=](const Hit& hit, int x, int y) {
        const auto at_normal = [&](const EnvironmentMap& table) {
            return table.interpolated(table.column(hit.normal.x, hit.normal.z), table.row(hit.normal.y));
        };
        const Colour sky_irradiance = at_normal(by_sky), sun_irradiance = at_normal(by_sun);
        const double sky_part = brightness(sky_irradiance), sun_part = deviation * brightness(sun_irradiance);
        const PixelRules* rule = &rules.front();
        while (sun_part > 0 && rule != &rules.back() &&
               static_cast<double>(rule->settings.samples) > samples * sky_part / (sky_part + sun_part) + 0.5)
            ++rule;
        Random random = pixel_stream(rule->settings, x, y);
        const OrientedRule oriented = rule->rule_for(hit.normal, random);
        Colour irradiance = sky_irradiance * visible_sky(around, hit, *oriented.rule, oriented.frame);
        if (sun_part > 0) {
            const std::size_t rays =
                std::max(rules[0].settings.samples, oriented.rule->size() + 1) - oriented.rule->size();
            irradiance += sun_irradiance * visible_sun(sun, hit, rays, random.uniform());
        }
        return 1 / pi * (hit.albedo * irradiance);
    };
}
}  // namespace bmc
