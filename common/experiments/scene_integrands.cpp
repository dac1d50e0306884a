#include "experiments/scene_integrands.h"

#include "scene/desert.h"
#include "scene/scene.h"

#include <memory>

namespace {

Integrand scene_integrand(const std::shared_ptr<const EnvironmentMap>& environment, const Scene& scene,
                          const Hit& hit) {
    const Frame frame(hit.normal);
    Integrand integrand{"scene", "L(w) cos(theta) at a point of the scene", nullptr, 0};
    integrand.value = [=](Vec3 local) {
        const Vec3 direction = frame.to_world(local);
        return is_shadowed(scene, hit, direction) ? 0 : dot(luminance, environment->radiance(direction)) * local.y;
    };
    integrand.truth = dense_quadrature(integrand);
    return integrand;
}

}  // namespace

std::vector<Integrand> scene_integrands() {
    const auto environment = std::make_shared<const EnvironmentMap>(built_in_environment());
    const Scene scene = sphere_scene();
    const Camera camera{500, 500};
    std::vector<Integrand> integrands;
    for (const auto& [x, y] : {std::pair<int, int>{250, 90}, {130, 250}, {370, 320}, {250, 460}, {60, 430}})
        integrands.push_back(scene_integrand(environment, scene, intersect(scene, camera.ray(x, y)).value()));
    return integrands;
}
