#include "numerics/vec3.h"
#include "test.h"

TEST_CASE("vectors are added, scaled and multiplied component by component") {
    Vec3 sum{1, 2, 3};
    CHECK((sum += {10, 20, 40}) == Vec3{11, 22, 43});
    CHECK(Vec3{1, 2, 3} - Vec3{2, 5, 9} == Vec3{-1, -3, -6});
    CHECK(2 * Vec3{1, 2, 4} == Vec3{2, 4, 8});
    CHECK(Color{1, 2, 4} * Color{3, 5, 7} == Vec3{3, 10, 28});
}

TEST_CASE("products, lengths and squared distances are those of space") {
    CHECK(dot({1, 2, 4}, {3, 5, 7}) == 41);
    CHECK(length({2, -3, 6}) == 7);
    CHECK(squared_distance({1, 2, 3}, {3, -1, 9}) == 49);
    CHECK(normalize({0, 3, -4}) == (1.0 / 5) * Vec3{0, 3, -4});
}
