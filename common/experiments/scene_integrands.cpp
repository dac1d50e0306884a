#include "experiments/scene_integrands.h"

#include "scene/scene.h"

namespace {

Integrand scene_integrand(const std::shared_ptr<const EnvironmentMap>& light, const Scene& scene, const Hit& hit,
                          const QuadratureRule& dense) {
    const Frame frame(hit.normal);
    Integrand integrand{"scene", "L(w) cos(theta) at a point of the scene", nullptr, 0};
    integrand.value = [=](Vec3 local) {
        const Vec3 direction = frame.to_world(local);
        return is_shadowed(scene, hit, direction) ? 0 : dot(luminance, light->radiance(direction)) * local.y;
    };
    integrand.truth = apply(dense, integrand);
    return integrand;
}

}  // namespace

std::vector<Integrand> scene_integrands(const std::shared_ptr<const EnvironmentMap>& light, std::size_t points) {
    const Scene scene = sphere_scene();
    const Camera camera{500, 500};
    const QuadratureRule dense = monte_carlo_rule({Placement::fibonacci, fibonacci_directions(1 << 16)});
    Random random(1, 0);
    std::vector<Integrand> integrands;
    while (integrands.size() < points) {
        const int x = static_cast<int>(500 * random.uniform()), y = static_cast<int>(500 * random.uniform());
        if (const auto hit = intersect(scene, camera.ray(x, y)))
            integrands.push_back(scene_integrand(light, scene, *hit, dense));
    }
    return integrands;
}
