#include "scene/scene.h"
#include "test.h"

static const Scene both{{{0, 0, -5}, 2, {1, 0, 0}}, {-2, -4, 4, -9, -1, {0, 1, 0}}};

// The centre of the top one of three rows is 2/3 up to the edge, which is at tan(30 degrees).
TEST_CASE("the camera sees 60 degrees vertically, through pixel centres, row 0 at the top") {
    const Camera camera{3, 3};
    const Vec3 up = camera.ray(1, 0).direction;
    CHECK(camera.ray(1, 1).origin == Vec3{0, 0, 0});
    CHECK(camera.ray(1, 1).direction == Vec3{0, 0, -1});
    CHECK(std::fabs(up.y / -up.z - 2.0 / 3 * std::tan(pi / 6)) < 1e-15);
    CHECK(std::fabs(length(up) - 1) < 1e-15);
    CHECK(camera.ray(2, 1).direction.x == up.y);
}

TEST_CASE("rays meet the sphere, the rectangle, the nearer of both, or nothing") {
    const auto hit = [](Vec3 from, Vec3 direction) { return intersect(both, {from, normalize(direction)}); };
    const Hit ahead = hit({0, 0, 0}, {0, 0, -1}).value(), down = hit({0, 0, 0}, {0, -2, -1.5}).value();
    CHECK(std::vector{ahead.point, ahead.normal, ahead.albedo} == std::vector<Vec3>{{0, 0, -3}, {0, 0, 1}, {1, 0, 0}});
    CHECK(std::vector{down.normal, down.albedo} == std::vector<Vec3>{{0, 1, 0}, {0, 1, 0}});
    CHECK(std::fabs(down.point.z + 1.5) < 1e-15);
    CHECK(hit({3, -5, -5}, {0, 1, 0})->normal == Vec3{0, -1, 0});
    CHECK(hit({0, 0, 0}, {0, -1.5, -5})->object == Object::sphere);
    CHECK(hit({0, -5, -5.5}, {0, 1, 0})->object == Object::rectangle);  // from below
    CHECK(!hit({0, 0, 0}, {0, 1, 0}));
    CHECK(!hit({0, 0, 0}, {0, 0, 1}));   // behind
    CHECK(!hit({0, -1, 0}, {1, 0, 0}));  // parallel
    for (const Vec3& to_edge : {Vec3{4, 0, 0}, {-4, 0, 0}, {3.5, 0, 4}, {3.5, 0, -4}}) {
        CAPTURE(to_edge);
        CHECK(hit(Vec3{0, -1.9, -5} + 0.99 * to_edge, {0, -1, 0}));
        CHECK(!hit(Vec3{0, -1.9, -5} + 1.01 * to_edge, {0, -1, 0}));
    }
}

// From either side of both objects, and past their edges.
TEST_CASE("a direction is shadowed where a ray meets the other object") {
    const Scene alone[] = {{both.sphere, {}}, {{}, both.rectangle}};
    int shadowed[2] = {};
    Random random(1, 0);
    for (const Vec3& direction : all_around(10000)) {
        const double x = random.uniform(), y = random.uniform(), z = random.uniform();
        const Vec3 from{10 * x - 5, 7 * y - 4, -11 * z};
        if (length(from - both.sphere.centre) <= both.sphere.radius) continue;
        INFO("from, direction: ", from, ", ", direction);
        for (const int other : {0, 1}) {
            const bool covered = is_shadowed(both, {static_cast<Object>(1 - other), from, {}, {}}, direction);
            CHECK(covered == intersect(alone[other], {from, direction}).has_value());
            shadowed[other] += covered;
        }
    }
    for (const int count : shadowed) CHECK(count > 300);
}
