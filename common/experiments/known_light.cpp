#include "scene/known_light.h"

#include "experiments/picture_cost.h"
#include "experiments/reports.h"
#include "light/texels_on_sphere.h"

namespace bmc {
using portable::pi;

// What renderers do with a light that they know: half of the samples are drawn in proportion to the light and
// stratified, the others are the directions of a rule of these settings, of density cos(theta) / pi. Each is weighted
// by the balance heuristic of multiple importance sampling (Veach & Guibas, "Optimally combining sampling techniques
// for Monte Carlo rendering", SIGGRAPH 1995). With the table of E(n), the sum is divided by itself without shadows and
// multiplied by E(n) (Heitz, Hill & McGuire, "Combining analytic direct illumination and stochastic shadows", I3D
// 2018).
static Shader mis_shader(const EnvironmentMap& map, const std::vector<Lamp>& lamps, const EnvironmentMap* irradiance,
                         RenderSettings settings) {
    const auto all = static_cast<double>(settings.samples), light_points = static_cast<double>(lamps.size());
    settings.samples = (settings.samples + 1) / 2;
    return [=, &map, &lamps, rules = PixelRules(settings)](const Hit& hit, int x, int y) {
        Random random = pixel_stream(settings, x, y);
        const OrientedRule oriented = rules.rule_for(hit.normal, random);
        std::vector<Vec3> directions = oriented.rule->directions;
        for (Vec3& direction : directions) direction = oriented.frame.to_world(direction);
        const double by_cosine = static_cast<double>(directions.size()), by_light = all - by_cosine;
        for (double j = 0; j < by_light; ++j)
            directions.push_back(lamps[std::size_t((j + random.uniform()) / by_light * light_points)].direction);
        Colour sum, visible;
        for (const Vec3& direction : directions) {
            const double cosine = std::max(0.0, dot(hit.normal, direction));
            const Colour radiance = map.radiance(direction);
            const double drawn = by_light * brightness(radiance) / (light_points * brightness(lamps[0].light));
            if (cosine > 0) sum += cosine / (drawn + by_cosine * cosine / pi) * radiance;
            if (cosine > 0 && !is_shadowed(sphere_scene, hit, direction))
                visible += cosine / (drawn + by_cosine * cosine / pi) * radiance;
        }
        if (!irradiance) return 1 / pi * (hit.albedo * visible);
        const Vec3 n = hit.normal;
        return 1 / pi *
               (hit.albedo * fraction(visible, sum) *
                irradiance->interpolated(irradiance->column(n.x, n.z), irradiance->row(n.y)));
    };
}

static std::string known_light_table(const CostSettings& costs, const std::string& name, const EnvironmentMap& map) {
    const RenderSettings dense = row_settings(costs, {}, 1);
    const std::vector<Lamp> lamps = points_of_light(map, 0, 1 << 16);
    const EnvironmentMap irradiance = light_around(cells_of_light(map, 1e300, 64), 0, 128, 0, dense.threads);
    constexpr Placement stratified{PointSet::stratified, Density::cosine};
    constexpr Placement optimised{PointSet::optimised, Density::cosine};
    std::vector<PictureCost> compared{
        compared_picture(map, Method::mc, 1, {}),         compared_picture(map, Method::pool, 20, {}),
        compared_picture(map, Method::mc, 1, stratified), compared_picture(map, Method::mc, 1, optimised),
        compared_picture(map, Method::mc, 1, optimised),  compared_picture(map, Method::mc, 1, optimised),
        compared_picture(map, Method::pool, 1, optimised)};
    PictureCost &mis = compared[4], &mis_ratio = compared[5], &pool = compared[6];
    mis.method_column = "mis";
    mis_ratio.method_column = "mis-ratio";
    mis.light_known = mis_ratio.light_known = pool.light_known = true;
    mis.image = [&](const auto& s) { return render(map, s, mis_shader(map, lamps, nullptr, s)); };
    mis_ratio.image = [&](const auto& s) { return render(map, s, mis_shader(map, lamps, &irradiance, s)); };
    pool.image = [&](const auto& s) { return render(map, s, known_light_shader(map, s)); };
    Statistics mean;
    const Image truth = render(map, dense, [&](const Hit& hit, int, int) {
        Colour sum;
        for (const auto& [direction, light] : lamps)
            if (!is_shadowed(sphere_scene, hit, direction)) sum += std::max(0.0, dot(hit.normal, direction)) * light;
        return 1 / pi * (hit.albedo * sum);
    });
    for_each_hit(sphere_scene, {costs.size, costs.size},
                 [&](int x, int y, const Hit&) { mean.add(brightness(truth(x, y)) / 3); });
    return formatted("# The sphere scene under %s. The mean radiance of the objects is %.4g.\n", name.c_str(),
                     mean.mean) +
           "# Columns as of tradeoff; mis: directions in proportion to the light, and to the cosine; mis-ratio: the "
           "same\n"
           "# sum over itself without shadows, times the light without shadows.\n" +
           measured_table(costs, compared, truth);
}

std::string known_light_report(Arguments& arguments) {
    return picture_report(taken_costs(arguments), known_light_table);
}
}  // namespace bmc
