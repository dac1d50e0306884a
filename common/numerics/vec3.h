// Three-dimensional vectors: points, directions, and colours as linear RGB.
#pragma once

#include "numerics/portable_math.h"

#include <cmath>

namespace bmc {
struct Vec3 {
    double x = 0, y = 0, z = 0;
};

using Color = Vec3;  // linear RGB: radiance, or a unitless albedo

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double s, Vec3 v) { return {s * v.x, s * v.y, s * v.z}; }
inline Vec3& operator+=(Vec3& a, Vec3 b) { return a = a + b; }
inline Color operator*(Color a, Color b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }  // channel by channel

inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double squared_distance(Vec3 a, Vec3 b) { return dot(a - b, a - b); }
inline double length(Vec3 v) { return std::sqrt(dot(v, v)); }

// The unit vector along v; v must not be zero.
inline Vec3 normalize(Vec3 v) { return (1 / length(v)) * v; }

// A ray's direction in the precision that rays have: single for directions and for what is looked up by them, since a
// processor computes twice as many side by side; double for weights and sums.
struct Direction {
    float x, y, z;

    Direction(float its_x, float its_y, float its_z) : x(its_x), y(its_y), z(its_z) {}
    explicit Direction(Vec3 v) : x(static_cast<float>(v.x)), y(static_cast<float>(v.y)), z(static_cast<float>(v.z)) {}
    explicit operator Vec3() const { return {x, y, z}; }
};

inline Direction operator+(Direction a, Direction b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Direction operator*(float s, Direction v) { return {s * v.x, s * v.y, s * v.z}; }
}  // namespace bmc
