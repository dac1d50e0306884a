#include "numerics/vec3.h"

#include "test.h"

TEST_CASE("a normalised vector has length 1 to rounding and keeps its direction") {
    const Vec3 v = normalize({3, -4, 12});
    CHECK(std::fabs(length(v) - 1) < 4e-16);
    CHECK(std::fabs(v.y + 4.0 / 13) < 2e-16);
}

TEST_CASE("the squared distance of points is that of Pythagoras") {
    CHECK(squared_distance({1, 2, 3}, {1, 5, -1}) == 25);
}
