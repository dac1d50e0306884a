#include "beyond/known_light_cost.h"

#include <stdexcept>

namespace bmc::beyond {
Shader mis_shader(const EnvironmentLight& light, const Sun& all, RenderSettings settings) {
    const double samples = static_cast<double>(settings.samples);
    settings.samples = (settings.samples + 1) / 2;
    return [=, &all, rules = PixelRules(settings)](const Hit& hit, int x, int y) {
        Random random = pixel_stream(settings, x, y);
        const OrientedRule oriented = rules.rule_for(hit.normal, random);
        std::vector<Vec3> directions = oriented.rule->directions;
        for (Vec3& direction : directions) direction = oriented.frame.to_world(direction);
        const double by_cosine = static_cast<double>(directions.size()), by_light = samples - by_cosine;
        for (double j = 0; j < by_light; ++j) {
            const double across = (j + random.uniform()) / by_light;
            directions.push_back(all.ray(across, random.uniform()).direction);
        }
        RatioEstimator sum;
        for (const Vec3& direction : directions) {
            const double cosine = dot(hit.normal, direction);
            if (cosine <= 0) continue;
            const Colour radiance = light.environment.radiance(direction);
            const double densities = by_light * brightness(radiance) / all.light() + by_cosine * cosine / portable::pi;
            sum.all += cosine / densities * radiance;
            if (!is_shadowed(sphere_scene, hit, direction)) sum.visible += cosine / densities * radiance;
        }
        if (!light.averages) return 1 / portable::pi * (hit.albedo * sum.visible);
        return 1 / portable::pi * (hit.albedo * light.averages->irradiance(hit.normal) * sum.fraction());
    };
}

std::string KnownLightReport::table(const std::string& name, const EnvironmentMap& map) const {
    constexpr int most = 1 << 23;  // which take 0.7 GB: each texel is a lamp of mis
    if (map.height > most / map.width)
        throw std::runtime_error(formatted("%s has %d x %d texels, but known-light takes at most %d; shrink it",
                                           name.c_str(), map.width, map.height, most));
    const RenderSettings dense = row_settings(costs, {}, 10000);
    const EnvironmentLight known(map, true, dense.threads), unknown(map, false, dense.threads);
    const Sun all(map, 0);
    constexpr Placement stratified{PointSet::stratified, KnownPart::cosine};
    constexpr Placement optimised{PointSet::optimised, KnownPart::cosine};
    PictureCost mis = compared_picture(map, Method::mc, 1, optimised), mis_ratio = mis;
    PictureCost shadows = compared_picture(map, Method::pool, 1, optimised);
    mis.method_column = "mis";
    mis_ratio.method_column = "mis-ratio";
    mis.image = [&](const RenderSettings& s) { return render(map, s, mis_shader(unknown, all, s)); };
    mis_ratio.image = [&](const RenderSettings& s) { return render(map, s, mis_shader(known, all, s)); };
    shadows.image = [&](const RenderSettings& s) { return render(map, s, light_shader(known, s)); };
    mis.light_known = mis_ratio.light_known = shadows.light_known = true;
    const std::vector<PictureCost> compared{compared_picture(map, Method::mc, 1, {}),
                                            compared_picture(map, Method::pool, 20, {}),
                                            compared_picture(map, Method::mc, 1, stratified),
                                            compared_picture(map, Method::pool, 20, stratified),
                                            compared_picture(map, Method::mc, 1, optimised),
                                            mis,
                                            mis_ratio,
                                            shadows};
    const Image truth = render(map, dense, sun_shader(map, dense, dense.samples));
    Statistics mean;
    for_each_hit(sphere_scene, {costs.size, costs.size},
                 [&](int x, int y, const Hit&) { mean.add(brightness(truth(x, y)) / 3); });
    return "# The sphere scene under " + name +
           formatted(R"(. The mean radiance of the objects is %.4g.
# Columns as of tradeoff; mis: directions in proportion to the light, and to the cosine, by multiple importance
# sampling; mis-ratio: the same sum over itself without shadows, times the light without shadows.
# Their times are those of plain code, which draws half of the directions anew for each pixel.
)",
                     mean.mean) +
           measured_table(compared, truth);
}
}  // namespace bmc::beyond
