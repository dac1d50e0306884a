#include "beyond/known_light_cost.h"

namespace bmc::beyond {
Shader mis_shader(const EnvironmentMap& map, const Sun& light, const RenderSettings& settings) {
    return [&map, &light, settings](const Hit& hit, int x, int y) {
        Random random = pixel_stream(settings, x, y);
        const Frame frame(hit.normal);
        std::vector<Vec3> directions = stratified_directions((settings.samples + 1) / 2, random, KnownPart::cosine);
        for (Vec3& direction : directions) direction = frame.to_world(direction);
        const double by_cosine = static_cast<double>(directions.size());
        const double by_light = static_cast<double>(settings.samples) - by_cosine;
        for (double j = 0; j < by_light; ++j) {
            const double across = (j + random.uniform()) / by_light;
            directions.push_back(light.ray(across, random.uniform()).direction);
        }
        Colour irradiance;
        for (const Vec3& direction : directions) {
            const double cosine = dot(hit.normal, direction);
            if (cosine <= 0 || is_shadowed(sphere_scene, hit, direction)) continue;
            const Colour radiance = map.radiance(direction);
            const double densities =
                by_light * brightness(radiance) / light.light() + by_cosine * cosine / portable::pi;
            irradiance += cosine / densities * radiance;
        }
        return 1 / portable::pi * (hit.albedo * irradiance);
    };
}

std::string KnownLightReport::table(const std::string& name, const EnvironmentMap& map) const {
    const RenderSettings dense = row_settings(costs, {}, 10000);
    const EnvironmentLight known(map, true, dense.threads);
    const Sun all(map, 0);
    constexpr Placement stratified{PointSet::stratified, KnownPart::cosine};
    constexpr Placement optimised{PointSet::optimised, KnownPart::cosine};
    PictureCost mis = compared_picture(map, Method::mc, 1, stratified);
    PictureCost shadows = compared_picture(map, Method::pool, 1, optimised);
    mis.method_column = "mis";
    mis.image = [&](const RenderSettings& s) { return render(map, s, mis_shader(map, all, s)); };
    shadows.image = [&](const RenderSettings& s) { return render(map, s, light_shader(known, s)); };
    mis.light_known = shadows.light_known = true;
    const std::vector<PictureCost> compared{compared_picture(map, Method::mc, 1, {}),
                                            compared_picture(map, Method::pool, 20, {}),
                                            compared_picture(map, Method::mc, 1, stratified),
                                            compared_picture(map, Method::pool, 20, stratified),
                                            compared_picture(map, Method::mc, 1, optimised),
                                            mis,
                                            shadows};
    const Image truth = render(map, dense, sun_shader(map, dense, dense.samples));
    Statistics mean;
    for_each_hit(sphere_scene, {costs.size, costs.size},
                 [&](int x, int y, const Hit&) { mean.add(brightness(truth(x, y)) / 3); });
    return "# The sphere scene under " + name +
           formatted(R"(. The mean radiance of the objects is %.4g.
# Columns as of tradeoff; mis: directions in proportion to the light, and to the cosine, by multiple importance
# sampling.
)",
                     mean.mean) +
           measured_table(compared, truth);
}
}  // namespace bmc::beyond
