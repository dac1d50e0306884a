#include "quadrature/hemisphere.h"

#include "test.h"

namespace {

double largest_difference(Vec3 a, Vec3 b) {
    return std::max({std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)});
}

Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

}  // namespace

// The uniform density: the cosine is uniform in (0, 1], variances 1/12 and 4/45 of the cosine and its square, 1/3 of x
// and z, 1/15 of x z. The density cos(theta) / pi: the square of the cosine is uniform, E cos = 2/3 with variance 1/2 -
// 4/9, E x^2 = 1/4 and E (x z)^2 = 1/24.
TEST_CASE("random directions are unit vectors of the upper hemisphere with the moments of their density") {
    constexpr std::size_t n = 200000;
    for (const bool cosine : {false, true}) {
        Random random(1, 0);
        double sums[5] = {};
        for (const Vec3& d : cosine ? cosine_directions(n, random) : uniform_directions(n, random)) {
            REQUIRE(std::fabs(length(d) - 1) < 1e-15);
            REQUIRE(d.y > 0);
            const double moments[] = {d.y, d.y * d.y, d.x, d.z, d.x * d.z};
            for (std::size_t i = 0; i < 5; ++i) sums[i] += moments[i] / n;
        }
        const double means[2][5] = {{1.0 / 2, 1.0 / 3}, {2.0 / 3, 1.0 / 2}};
        const double variances[2][5] = {{1.0 / 12, 4.0 / 45, 1.0 / 3, 1.0 / 3, 1.0 / 15},
                                        {1.0 / 18, 1.0 / 12, 1.0 / 4, 1.0 / 4, 1.0 / 24}};
        CAPTURE(cosine);
        for (std::size_t i = 0; i < 5; ++i)
            CHECK(std::fabs(sums[i] - means[cosine][i]) < 5 * std::sqrt(variances[cosine][i] / n));  // standard errors
    }
}

TEST_CASE("Fibonacci directions have equidistant elevation cosines, or their squares, and keep apart") {
    constexpr std::size_t n = 100;
    const std::vector<Vec3> directions = fibonacci_directions(n), by_cosine = cosine_fibonacci_directions(n);
    double nearest = 2;
    for (std::size_t i = 0; i < n; ++i) {
        const double u = 1 - (static_cast<double>(i) + 0.5) / n;
        CHECK(directions[i].y == u);
        CHECK(std::fabs(by_cosine[i].y * by_cosine[i].y - u) < 2e-16);
        for (const Vec3& d : {directions[i], by_cosine[i]}) CHECK(std::fabs(length(d) - 1) < 1e-15);
        for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, length(directions[i] - directions[j]));
    }
    // A square cell of the mean solid angle 2 pi / n has side sqrt(2 pi / n): a well-spread set keeps most of it.
    CHECK(nearest > 0.7 * std::sqrt(2 * pi / n));
}

TEST_CASE("rotation about y keeps elevation, length and the angles between directions") {
    Random random(2, 0);
    const std::vector<Vec3> directions = uniform_directions(50, random);
    for (std::size_t i = 0; i + 1 < directions.size(); ++i) {
        const double turns = random.uniform();
        const Vec3 a = rotate_around_y(directions[i], turns), b = rotate_around_y(directions[i + 1], turns);
        CHECK(a.y == directions[i].y);
        CHECK(std::fabs(dot(a, b) - dot(directions[i], directions[i + 1])) < 1e-15);
    }
    CHECK(largest_difference(rotate_around_y({0, 0.6, 0.8}, 0.25), {0.8, 0.6, 0}) == 0);  // from z towards x
}

TEST_CASE("a frame is orthonormal and right-handed around every normal, the axes and their neighbours included") {
    std::vector<Vec3> normals = random_normals(2000);
    for (double sign : {1.0, -1.0})
        for (double tilt : {0.0, 1e-9, -1e-9, 1e-300})
            for (Vec3 axis : {Vec3{sign, tilt, 0}, Vec3{0, sign, tilt}, Vec3{tilt, 0, sign}, Vec3{0, tilt, sign}})
                normals.push_back(axis);
    for (const Vec3& normal : normals) {
        const Frame frame(normal);
        // A dozen roundings of numbers of size 1.
        CHECK(std::fabs(dot(frame.tangent, frame.tangent) - 1) < 2e-15);
        CHECK(std::fabs(dot(frame.tangent, normal)) < 2e-15);
        CHECK(largest_difference(cross(frame.tangent, normal), frame.bitangent) < 2e-15);
        CHECK(largest_difference(frame.to_world(Vec3{0, 1, 0}), normal) == 0);
    }
}

TEST_CASE("a rotated frame carries a direction to where the frame carries the rotated direction") {
    const Frame frame(normalize({0.3, -0.5, 0.8}));
    Random random(4, 0);
    for (const Vec3& direction : uniform_directions(20, random)) {
        const double turns = random.uniform();
        CHECK(largest_difference(frame.rotated(turns).to_world(direction),
                                 frame.to_world(rotate_around_y(direction, turns))) < 1e-15);
    }
}
