#include "quadrature/hemisphere.h"
#include "scene/scene.h"
#include "test.h"

#include <map>

static const Rectangle plate{-2, -4, 4, -9, -1, {0, 1, 0}};

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
    const Scene scene{{{0, 0, -5}, 2, {1, 0, 0}}, plate};
    const auto hit = [&](Vec3 from, Vec3 direction) { return intersect(scene, {from, normalize(direction)}); };
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

TEST_CASE("a direction is shadowed where a ray meets the other object") {
    std::map<Object, int> shadowed, all;  // directions, of each object
    for_each_hit(test_scene(), {24, 24}, [&](int, int, const Hit& hit) {
        for (const Vec3& local : some_directions(30)) {
            const Vec3 direction = Frame(hit.normal).to_world(local);
            const bool covered = is_shadowed(test_scene(), hit, direction);
            // Off the surface, so that the ray does not meet its own origin.
            INFO("hit.point, direction: ", hit.point, ", ", direction);
            CHECK(covered == intersect(test_scene(), {hit.point + 1e-9 * hit.normal, direction}).has_value());
            shadowed[hit.object] += covered;
            ++all[hit.object];
        }
    });
    CHECK(all.size() > 1);
    for (const auto& each : all) {  // clang++ captures no structured binding
        CAPTURE(static_cast<int>(each.first));
        CHECK(shadowed[each.first] > 300);
        CHECK(shadowed[each.first] < each.second - 300);
    }
}

// In the scene itself no ray has the sphere behind it and its line through the sphere.
TEST_CASE("a sphere shadows in front of a ray, not behind it") {
    const Sphere sphere{{0, 0, -5}, 2, {}};
    CHECK(is_shadowed_by(sphere, {}, {0, 0, -1}));
    CHECK(!is_shadowed_by(sphere, {}, {0, 0, 1}));
}

TEST_CASE("a rectangle shadows what is below and what is above, up to its edges") {
    for (const double side : {-1.0, 1.0}) {
        const auto covers = [&](Vec3 to) { return is_shadowed_by(plate, {1, -2 + 2 * side, -5}, normalize(to)); };
        CHECK(!covers({0, side, 0}));
        CHECK(!covers({1, 0, 0}));
        for (const Vec3& to_edge : {Vec3{3, 0, 0}, {-5, 0, 0}, {0, 0, 4}, {0, 0, -4}}) {
            INFO("side, to_edge: ", side, ", ", to_edge);
            CHECK(covers(0.99 * to_edge + Vec3{0, -2 * side, 0}));
            CHECK(!covers(1.01 * to_edge + Vec3{0, -2 * side, 0}));
        }
    }
}
