#include "numerics/vec3.h"
#include "test.h"

TEST_CASE("vectors are added, scaled and multiplied component by component") {
    const Vec3 a{1, 2, 4}, b{3, 5, 7};
    CHECK(std::vector{a + b, a - b, 2 * a, a * b} ==
          std::vector<Vec3>{{4, 7, 11}, {-2, -3, -3}, {2, 4, 8}, {3, 10, 28}});
}

TEST_CASE("products, lengths and squared distances are those of space") {
    CHECK(Numbers{dot({1, 2, 4}, {3, 5, 7}), length({2, -3, 6}), squared_distance({1, 2, 3}, {3, -1, 9})} ==
          Numbers{41, 7, 49});
    CHECK(normalize({0, 3, -4}) == (1.0 / 5) * Vec3{0, 3, -4});
}
