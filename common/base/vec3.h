// Three-dimensional vectors: points, directions, and colours as linear RGB.
#pragma once

#include "base/portable_math.h"

namespace bmc {
struct Vec3 {
    double x = 0, y = 0, z = 0;
};

using Colour = Vec3;  // linear RGB: radiance, or a unitless albedo

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double s, Vec3 v) { return {s * v.x, s * v.y, s * v.z}; }
inline Vec3& operator+=(Vec3& a, Vec3 b) { return a = a + b; }
inline Colour operator*(Colour a, Colour b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }  // channel by channel

inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double luminance(Colour c) { return dot({0.2126, 0.7152, 0.0722}, c); }  // Rec. 709
inline double channel_sum(Colour c) { return c.x + c.y + c.z; }  // one number for a radiance, whatever its colour
inline double squared_distance(Vec3 a, Vec3 b) { return dot(a - b, a - b); }
inline double length(Vec3 v) { return std::sqrt(dot(v, v)); }

// The unit vector along v; v must not be zero.
inline Vec3 normalize(Vec3 v) { return (1 / length(v)) * v; }
}  // namespace bmc
