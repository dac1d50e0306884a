// The practice's sphere scene: one camera, one sphere on one rectangle, lit by the environment alone. It holds what
// this picture requires and nothing else.
#pragma once

#include "numerics/vec3.h"

#include <optional>

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

// The number of pixels that show an object.
double object_pixels(const Scene& scene, int width, int height);

// The tests that decide whether a shadow ray from a point outside the object meets it: neither divides nor branches, so
// a loop over many directions vectorises. They compute in the precision of the direction's components. The objects are
// convex, so a hit on one can only be shadowed by the other.

// |o|^2 - (o.d)^2 < radius^2 for the offset o to the centre, where the centre lies ahead.
class SphereShadow {
public:
    SphereShadow(const Sphere& sphere, Vec3 point)
        : offset_(sphere.centre - point), excess_(dot(offset_, offset_) - sphere.radius * sphere.radius) {}

    template <class Real>
    bool covers(Real x, Real y, Real z) const {
        const Real ahead = Real(offset_.x) * x + Real(offset_.y) * y + Real(offset_.z) * z;
        return (ahead > 0) & (ahead * ahead > Real(excess_));
    }
    bool covers(Vec3 direction) const { return covers(direction.x, direction.y, direction.z); }

private:
    Vec3 offset_;
    double excess_;
};

// From a height h on either side of the plane, the point where the ray meets it, multiplied by the ray's approach.
class RectangleShadow {
public:
    RectangleShadow(const Rectangle& rectangle, Vec3 point)
        : towards_(point.y < rectangle.y ? 1 : -1),
          height_(std::fabs(point.y - rectangle.y)),
          left_(rectangle.x_min - point.x),
          right_(rectangle.x_max - point.x),
          far_(rectangle.z_min - point.z),
          near_(rectangle.z_max - point.z) {}

    template <class Real>
    bool covers(Real x, Real y, Real z) const {
        const Real approach = Real(towards_) * y, across = Real(height_) * x, along = Real(height_) * z;
        return (approach > 0) & (across >= Real(left_) * approach) & (across <= Real(right_) * approach) &
               (along >= Real(far_) * approach) & (along <= Real(near_) * approach);
    }
    bool covers(Vec3 direction) const { return covers(direction.x, direction.y, direction.z); }

private:
    double towards_, height_, left_, right_, far_, near_;
};
