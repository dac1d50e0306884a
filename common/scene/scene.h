// The practice's sphere scene: one camera, one sphere on one rectangle, lit by the environment alone. It holds what
// this picture requires and nothing else.
#pragma once

#include "numerics/vec3.h"

#include <optional>

namespace bmc {
struct Ray {
    Vec3 origin;
    Vec3 direction;  // unit length
};

struct Sphere {
    Vec3 centre;
    double radius;
    Color albedo;
};

// A horizontal rectangle at height y, two-sided.
struct Rectangle {
    double y;
    double x_min, x_max;
    double z_min, z_max;
    Color albedo;
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

Scene sphere_scene();

enum class Object { sphere, rectangle };

struct Hit {
    Object object;
    Vec3 point;
    Vec3 normal;  // unit length, on the side that the ray came from
    Color albedo;
};

// The first object that the ray meets.
std::optional<Hit> intersect(const Scene& scene, const Ray& ray);

// Whether the object blocks light arriving at a point outside of it from a direction, a Vec3 or a Direction. It
// is computed in the direction's precision and without a branch, so that a loop can try many directions side by side.
// A sphere shadows if its centre lies ahead and |o|^2 - (o.d)^2 < radius^2, where o is the offset to the centre.
template <class Vector>
bool is_shadowed_by(const Sphere& sphere, Vec3 point, Vector direction) {
    using Real = decltype(direction.x);
    const Vec3 o = sphere.centre - point;
    const Real ahead = Real(o.x) * direction.x + Real(o.y) * direction.y + Real(o.z) * direction.z;
    return (ahead > 0) & (ahead * ahead > Real(dot(o, o) - sphere.radius * sphere.radius));
}

// The point where the ray meets the plane, times the ray's approach to it, from either side.
template <class Vector>
bool is_shadowed_by(const Rectangle& rectangle, Vec3 point, Vector direction) {
    using Real = decltype(direction.x);
    const Real height = Real(std::fabs(point.y - rectangle.y));
    const Real approach = point.y < rectangle.y ? direction.y : -direction.y;
    const Real across = height * direction.x, along = height * direction.z;
    return (approach > 0) & (across >= Real(rectangle.x_min - point.x) * approach) &
           (across <= Real(rectangle.x_max - point.x) * approach) &
           (along >= Real(rectangle.z_min - point.z) * approach) &
           (along <= Real(rectangle.z_max - point.z) * approach);
}

// f of the object that can shadow a hit: the other one, since both are convex.
template <class Function>
auto of_other_object(const Scene& scene, const Hit& hit, Function f) {
    return hit.object == Object::sphere ? f(scene.rectangle) : f(scene.sphere);
}

template <class Vector>
bool is_shadowed(const Scene& scene, const Hit& hit, Vector direction) {
    return of_other_object(scene, hit, [&](const auto& other) { return is_shadowed_by(other, hit.point, direction); });
}

// Calls f(x, y, hit) for each pixel that shows an object, row after row.
template <class Function>
void for_each_hit(const Scene& scene, const Camera& camera, Function f) {
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            if (const std::optional<Hit> hit = intersect(scene, camera.ray(x, y))) f(x, y, *hit);
}

// The number of these pixels.
inline double object_pixels(const Scene& scene, const Camera& camera) {
    double count = 0;
    for_each_hit(scene, camera, [&](int, int, const Hit&) { ++count; });
    return count;
}
}  // namespace bmc
