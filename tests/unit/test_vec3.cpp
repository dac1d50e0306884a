#include "numerics/vec3.h"

#include <doctest/doctest.h>

TEST_CASE("the cross product is orthogonal to both factors and right-handed") {
    const Vec3 a{1, 2, 3}, b{-4, 5, 0.5}, c = cross(a, b);
    // Products of small dyadic numbers are exact.
    CHECK(dot(a, c) == 0);
    CHECK(dot(b, c) == 0);
    CHECK(cross({1, 0, 0}, {0, 1, 0}).z == 1);
}

TEST_CASE("a normalised vector has length 1 to rounding and keeps its direction") {
    const Vec3 v = normalize({3, -4, 12});
    CHECK(std::fabs(length(v) - 1) < 4e-16);
    CHECK(std::fabs(v.y + 4.0 / 13) < 2e-16);
}

TEST_CASE("the squared distance of points is that of Pythagoras") {
    CHECK(squared_distance({1, 2, 3}, {1, 5, -1}) == 25);
}
