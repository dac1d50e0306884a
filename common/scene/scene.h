// The practice's sphere scene: one camera, one sphere on one rectangle, lit by the environment alone.
#pragma once

#include "base/vec3.h"

#include <optional>

namespace bmc {
struct Ray {
    Vec3 origin;
    Vec3 direction;  // unit length
};

struct Sphere {
    Vec3 centre;
    double radius;
    Colour albedo;
};

// A horizontal rectangle at height y, two-sided.
struct Rectangle {
    double y;
    double x_min, x_max;
    double z_min, z_max;
    Colour albedo;
};

// A pinhole camera at the origin that looks down -z, y up, with a vertical field of view of 60 degrees.
struct Camera {
    int width, height;

    // The ray through the centre of the pixel in column x of row y, row 0 at the top.
    Ray ray(int x, int y) const;
};

struct Scene {
    Sphere sphere;
    Rectangle rectangle;
};

extern const Scene sphere_scene;

enum class Object { sphere, rectangle };

struct Hit {
    Object object;
    Vec3 point;
    Vec3 normal;  // unit length, on the side that the ray came from
    Colour albedo;
};

// The first object that the ray meets.
std::optional<Hit> intersect(const Scene& scene, const Ray& ray);

// Calls f(x, y, hit) for each pixel that shows an object of the sphere scene, row after row.
template <class Function>
void for_each_hit(const Camera& camera, Function f) {
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            if (const std::optional<Hit> hit = intersect(sphere_scene, camera.ray(x, y))) f(x, y, *hit);
}

// The number of these pixels.
inline double pixels_of_objects(const Camera& camera) {
    double pixels = 0;
    for_each_hit(camera, [&](int, int, const Hit&) { ++pixels; });
    return pixels;
}

// Whether the object blocks the light that arrives from a direction at a point outside of it. A sphere does if its
// centre lies ahead, o.d > 0 with o the offset to the centre, and the squared distance of the ray from the centre,
// |o|^2 - (o.d)^2, is less than radius^2. `&` computes both sides, where `&&` would be a branch.
inline bool is_shadowed_by(const Sphere& sphere, Vec3 point, Vec3 direction) {
    const Vec3 o = sphere.centre - point;
    const double ahead = dot(o, direction);
    return (ahead > 0) & (ahead * ahead > dot(o, o) - sphere.radius * sphere.radius);
}

// The ray meets the plane at point + t direction, t = height / approach. The rectangle is in the way if
//     t > 0, x_min <= point.x + t direction.x <= x_max, and z_min <= point.z + t direction.z <= z_max.
// Both sides of each comparison are multiplied by approach, so that nothing is divided by 0.
inline bool is_shadowed_by(const Rectangle& rectangle, Vec3 point, Vec3 direction) {
    const double height = std::fabs(point.y - rectangle.y);
    const double approach = point.y < rectangle.y ? direction.y : -direction.y;
    const double across = height * direction.x, along = height * direction.z;
    return (approach > 0) & (across >= (rectangle.x_min - point.x) * approach) &
           (across <= (rectangle.x_max - point.x) * approach) & (along >= (rectangle.z_min - point.z) * approach) &
           (along <= (rectangle.z_max - point.z) * approach);
}

// Both objects are convex, so only the other one can shadow a hit.
inline bool is_shadowed(const Scene& scene, const Hit& hit, Vec3 direction) {
    const bool on_sphere = hit.object == Object::sphere;
    const bool by_rectangle = is_shadowed_by(scene.rectangle, hit.point, direction);
    const bool by_sphere = is_shadowed_by(scene.sphere, hit.point, direction);
    return (on_sphere & by_rectangle) | (!on_sphere & by_sphere);
}
}  // namespace bmc
