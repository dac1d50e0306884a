#include "quadrature/hemisphere.h"
#include "scene/scene.h"
#include "test.h"

static const Rectangle plate{-2, -4, 4, -9, -1, {0, 1, 0}};

// The centre of the top one of three rows is 2/3 up to the edge, which is at tan(30 degrees).
TEST_CASE("the camera sees 60 degrees vertically, through pixel centres, row 0 at the top") {
    const Camera camera{3, 3};
    const Vec3 up = camera.ray(1, 0).direction, wide = Camera{4, 2}.ray(3, 0).direction;
    CHECK((same(camera.ray(1, 1).origin, {0, 0, 0}) && same(camera.ray(1, 1).direction, {0, 0, -1})));
    CHECK((std::fabs(up.y / -up.z - 2.0 / 3 * std::tan(pi / 6)) < 1e-15 && std::fabs(length(up) - 1) < 1e-15));
    CHECK((camera.ray(2, 1).direction.x == up.y && std::fabs(wide.x / wide.y - 3) < 1e-15));
}

TEST_CASE("the scene is the practice's") {
    const auto [sphere, rectangle] = sphere_scene();
    CHECK((same(sphere.centre, {0, 0, -5}) && sphere.radius == 2 && same(sphere.albedo, {0.8, 0.8, 0.8})));
    CHECK((rectangle.y == -2 && rectangle.x_min == -4 && rectangle.x_max == 4));
    CHECK((rectangle.z_min == -9 && rectangle.z_max == -1 && same(rectangle.albedo, {0.2, 0.8, 0.2})));
}

TEST_CASE("rays meet the sphere, the rectangle, the nearer of both, or nothing") {
    const Scene scene{{{0, 0, -5}, 2, {1, 0, 0}}, plate};
    const auto hit = [&](Vec3 from, Vec3 direction) { return intersect(scene, {from, normalize(direction)}); };
    const Hit ahead = hit({0, 0, 0}, {0, 0, -1}).value(), down = hit({0, 0, 0}, {0, -2, -1.5}).value();
    CHECK((ahead.object == Object::sphere && same(ahead.point, {0, 0, -3}) && same(ahead.normal, {0, 0, 1})));
    CHECK((down.object == Object::rectangle && same(down.normal, {0, 1, 0}) && std::fabs(down.point.z + 1.5) < 1e-15));
    CHECK((same(ahead.albedo, {1, 0, 0}) && same(down.albedo, {0, 1, 0})));
    CHECK(same(hit({3, -5, -5}, {0, 1, 0})->normal, {0, -1, 0}));
    // The sphere before the rectangle and, from below, the rectangle before the sphere; both behind; parallel.
    CHECK(hit({0, 0, 0}, {0, -1.5, -5})->object == Object::sphere);
    CHECK(hit({0, -5, -5.5}, {0, 1, 0})->object == Object::rectangle);
    CHECK((!hit({0, 0, 0}, {0, 1, 0}) && !hit({0, 0, 0}, {0, 0, 1}) && !hit({0, -1, 0}, {1, 0, 0})));
    for (const Vec3& to_edge : {Vec3{4, 0, 0}, {-4, 0, 0}, {3.5, 0, 4}, {3.5, 0, -4}}) {
        CHECK(hit(Vec3{0, -1.9, -5} + 0.99 * to_edge, {0, -1, 0}));
        CHECK(!hit(Vec3{0, -1.9, -5} + 1.01 * to_edge, {0, -1, 0}));
    }
}

TEST_CASE("each pixel that shows an object is passed once, row after row, with what its ray meets") {
    const Camera camera{30, 20};
    std::vector<bool> passed(600);
    std::size_t next = 0;
    for_each_hit(test_scene(), camera, [&](int x, int y, const Hit& hit) {
        const std::size_t pixel = static_cast<std::size_t>(30 * y + x);
        CHECK((pixel >= next && dot(hit.normal, camera.ray(x, y).direction) < 0));
        passed[pixel] = true;
        next = pixel + 1;
    });
    for (int i = 0; i < 600; ++i)
        CHECK(passed[static_cast<std::size_t>(i)] == intersect(test_scene(), camera.ray(i % 30, i / 30)).has_value());
}

TEST_CASE("a direction is shadowed where a ray meets the other object") {
    int shadowed[2] = {}, all[2] = {};
    for_each_hit(test_scene(), {24, 24}, [&](int, int, const Hit& hit) {
        for (const Vec3& local : some_directions(30)) {
            const Vec3 direction = Frame(hit.normal).to_world(local);
            const bool covered = is_shadowed(test_scene(), hit, direction);
            // Off the surface, so that the ray does not meet its own origin.
            CHECK(covered == intersect(test_scene(), {hit.point + 1e-9 * hit.normal, direction}).has_value());
            shadowed[static_cast<int>(hit.object)] += covered;
            ++all[static_cast<int>(hit.object)];
        }
    });
    for (const int object : {0, 1}) CHECK((shadowed[object] > 300 && shadowed[object] < all[object] - 300));
}

TEST_CASE("a sphere shadows in front of a ray, not behind it") {
    const Sphere sphere{{0, 0, -5}, 2, {}};
    CHECK((is_shadowed_by(sphere, {}, {0, 0, -1}) && !is_shadowed_by(sphere, {}, {0, 0, 1})));
}

TEST_CASE("a rectangle shadows what is below and what is above, up to each of its edges") {
    for (const double side : {-1.0, 1.0}) {
        const auto covers = [&](Vec3 to) { return is_shadowed_by(plate, {1, -2 + 2 * side, -5}, normalize(to)); };
        CHECK((!covers({0, side, 0}) && !covers({1, 0, 0})));
        for (const Vec3& to_edge : {Vec3{3, 0, 0}, {-5, 0, 0}, {0, 0, 4}, {0, 0, -4}}) {
            CHECK(covers(0.99 * to_edge + Vec3{0, -2 * side, 0}));
            CHECK(!covers(1.01 * to_edge + Vec3{0, -2 * side, 0}));
        }
    }
}
