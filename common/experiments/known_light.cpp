#include "scene/known_light.h"

#include "experiments/picture_cost.h"
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

std::vector<PictureCost> known_light_pictures(const EnvironmentMap& map) {
    constexpr Placement optimised{PointSet::optimised, Density::cosine};
    const auto lamps = std::make_shared<const std::vector<Lamp>>(points_of_light(map, 0, 1 << 16));
    const auto irradiance = std::make_shared<const EnvironmentMap>(
        light_around(cells_of_light(map, 1e300, 64), 0, 128, 0, RenderSettings().threads));
    PictureCost mis = compared_picture(map, Method::mc, 1, optimised), mis_ratio = mis;
    PictureCost pool = compared_picture(map, Method::pool, 1, optimised);
    mis.method_column = "mis";
    mis_ratio.method_column = "mis-ratio";
    mis.light_known = mis_ratio.light_known = pool.light_known = true;
    mis.image = [=, &map](const auto& s) { return render(map, s, mis_shader(map, *lamps, nullptr, s)); };
    mis_ratio.image = [=, &map](const auto& s) { return render(map, s, mis_shader(map, *lamps, irradiance.get(), s)); };
    pool.image = [&map](const auto& s) { return render(map, s, known_light_shader(map, s)); };
    return {mis, mis_ratio, pool};
}
}  // namespace bmc
