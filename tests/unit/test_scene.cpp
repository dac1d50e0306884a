#include "scene/scene.h"

#include "test.h"

TEST_CASE("the camera sees 60 degrees vertically, through pixel centres, row 0 at the top") {
    const Camera camera{3, 3};
    CHECK(camera.ray(1, 1).direction.z == -1);
    // The centre of the top row is 2/3 up to the edge, which is at tan(30 degrees).
    const Vec3 up = camera.ray(1, 0).direction, right = camera.ray(2, 1).direction;
    CHECK(std::fabs(up.y / -up.z - 2.0 / 3 * std::tan(pi / 6)) < 1e-15);
    CHECK(right.x == up.y);
    const Camera wide{4, 2};
    CHECK(std::fabs(wide.ray(3, 0).direction.x / wide.ray(3, 0).direction.y - 3) < 1e-15);
}

TEST_CASE("rays meet the sphere, the rectangle or nothing") {
    const Scene scene = sphere_scene();
    const auto hit = [&](Vec3 from, Vec3 direction) { return intersect(scene, {from, normalize(direction)}).value(); };
    const Hit ahead = hit({0, 0, 0}, {0, 0, -1}), down = hit({0, 0, 0}, {0, -2, -1.5});
    CHECK(ahead.object == Object::sphere);
    CHECK(ahead.point.z == -3);
    CHECK(ahead.normal.z == 1);
    CHECK(down.object == Object::rectangle);
    CHECK(std::fabs(down.point.y + 2) < 1e-15);
    CHECK(down.normal.y == 1);
    CHECK(hit({3, -5, -5}, {0, 1, 0}).normal.y == -1);
    // The first of two: the sphere before the rectangle and, from below, the rectangle before the sphere.
    CHECK(hit({0, 0, 0}, {0, -1.5, -5}).object == Object::sphere);
    CHECK(hit({0, -5, -5.5}, {0, 1, 0}).object == Object::rectangle);
    CHECK(!intersect(scene, {{0, 0, 0}, {0, 1, 0}}));
    CHECK(!intersect(scene, {{0, 0, 0}, {0, 0, 1}}));   // the sphere lies behind
    CHECK(!intersect(scene, {{0, -1, 0}, {1, 0, 0}}));  // parallel to the rectangle
}

TEST_CASE("hits lie on their object and face the ray") {
    const Scene scene = sphere_scene();
    const Camera camera{60, 60};
    int spheres = 0, rectangles = 0;
    for_each_hit(scene, camera, [&](int x, int y, const Hit& hit) {
        CHECK(dot(hit.normal, camera.ray(x, y).direction) < 0);
        ++(hit.object == Object::sphere ? spheres : rectangles);
        if (hit.object == Object::sphere) CHECK(std::fabs(length(hit.point - scene.sphere.centre) - 2) < 1e-14);
    });
    CHECK(object_pixels(scene, camera) == spheres + rectangles);
    CHECK(object_pixels(scene, {500, 500}) == 166094);
    CHECK(object_pixels(scene, {1000, 500}) > 166094);  // more of the rectangle, beside the square
}

TEST_CASE("a sphere shadows in the directions towards it, not away from it") {
    const Sphere sphere = sphere_scene().sphere;
    const Vec3 above{0, 5, -5};
    CHECK(is_shadowed_by(sphere, above, Vec3{0, -1, 0}));
    CHECK(!is_shadowed_by(sphere, above, Vec3{0, 1, 0}));
    CHECK(!is_shadowed_by(sphere, above, Vec3{1, 0, 0}));
}

TEST_CASE("shadow tests agree with intersection for every direction") {
    const Scene scene = sphere_scene();
    Random random(5, 0);
    int shadowed = 0, lit = 0;
    for_each_hit(scene, {24, 24}, [&](int, int, const Hit& hit) {
        const Frame frame(hit.normal);
        for (const Vec3& local : uniform_directions(30, random)) {
            const Vec3 direction = frame.to_world(local);
            const bool covered = is_shadowed(scene, hit, direction);
            // Off the surface, so that the ray does not meet its own origin.
            CHECK(covered == intersect(scene, {hit.point + 1e-9 * hit.normal, direction}).has_value());
            ++(covered ? shadowed : lit);
        }
    });
    CHECK(shadowed > 1000);
    CHECK(lit > 1000);
}

TEST_CASE("a rectangle shadows what lies below it as well as what lies above") {
    const Rectangle rectangle = sphere_scene().rectangle;
    for (const double side : {-1.0, 1.0}) {
        const Vec3 point{1, rectangle.y + 2 * side, -5};
        const auto covers = [&](Vec3 direction) { return is_shadowed_by(rectangle, point, direction); };
        CHECK(covers({0, -side, 0}));
        CHECK(!covers({0, side, 0}));
        CHECK(covers(normalize({2.9, -2 * side, 0})));  // x = 3.9, of at most 4
        CHECK(!covers(normalize({3.1, -2 * side, 0})));
        CHECK(covers(normalize({0, -2 * side, -3.9})));  // z = -8.9, of at least -9
        CHECK(!covers(normalize({0, -2 * side, -4.1})));
    }
}
