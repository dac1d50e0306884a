#include "scene/scene.h"

namespace bmc {
const Scene sphere_scene{{{0, 0, -5}, 2, {0.8, 0.8, 0.8}}, {-2, -4, 4, -9, -1, {0.2, 0.8, 0.2}}};

// Distance along the ray to the object, infinite unless it lies ahead.
static double distance(const Sphere& sphere, const Ray& ray) {
    const Vec3 offset = sphere.centre - ray.origin;
    const double ahead = dot(offset, ray.direction);
    const double discriminant = ahead * ahead - (dot(offset, offset) - sphere.radius * sphere.radius);
    if (discriminant < 0) return INFINITY;
    const double t = ahead - std::sqrt(discriminant);
    return t > 0 ? t : INFINITY;
}

static double distance(const Rectangle& rectangle, const Ray& ray) {
    const double t = (rectangle.y - ray.origin.y) / ray.direction.y;  // infinite or nan for a level ray: not inside
    const double x = ray.origin.x + t * ray.direction.x;
    const double z = ray.origin.z + t * ray.direction.z;
    const bool inside = x >= rectangle.x_min && x <= rectangle.x_max && z >= rectangle.z_min && z <= rectangle.z_max;
    return t > 0 && inside ? t : INFINITY;
}

Ray Camera::ray(int x, int y) const {
    // tan(30 degrees) = sqrt(1/3): half the height of the image plane at distance 1.
    const double scale = 2 * std::sqrt(1.0 / 3) / height;
    return {{0, 0, 0}, normalize({scale * (x + 0.5 - 0.5 * width), scale * (0.5 * height - y - 0.5), -1})};
}

std::optional<Hit> intersect(const Scene& scene, const Ray& ray) {
    const double to_sphere = distance(scene.sphere, ray), to_rectangle = distance(scene.rectangle, ray);
    const bool on_sphere = to_sphere <= to_rectangle;
    const double nearest = on_sphere ? to_sphere : to_rectangle;
    if (nearest == INFINITY) return std::nullopt;
    const Vec3 point = ray.origin + nearest * ray.direction;
    if (on_sphere) return Hit{Object::sphere, point, normalize(point - scene.sphere.centre), scene.sphere.albedo};
    return Hit{Object::rectangle, point, {0, ray.direction.y < 0 ? 1.0 : -1.0, 0}, scene.rectangle.albedo};
}
}  // namespace bmc
