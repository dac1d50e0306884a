#include "scene/desert.h"
#include "scene/render.h"

#include "experiments/picture_error.h"
#include "quadrature/gaussian_process.h"

#include <doctest/doctest.h>

#include <cmath>

using portable::pi;

namespace {

const Method all_methods[] = {Method::mc, Method::direct, Method::single, Method::rotated, Method::pool};

RenderSettings small(Method method) {
    RenderSettings settings;
    settings.method = method;
    settings.width = settings.height = 40;
    return settings;
}

std::string picture(const RenderSettings& settings) {
    return to_pfm(render(sphere_scene(), built_in_environment(), Sobolev(), settings));
}

Image dense_quadrature(const EnvironmentMap& environment) {
    RenderSettings settings = small(Method::mc);
    settings.placement = Placement::fibonacci;
    settings.samples = 20000;
    settings.threads = 2;
    return render(sphere_scene(), environment, Sobolev(), settings);
}

ImageError error_of(const Image& image, const Image& truth) { return image_error(sphere_scene(), {image}, truth); }

}  // namespace

TEST_CASE("1, 2 and 7 threads give the same bytes for every method") {
    for (Method method : all_methods) {
        RenderSettings settings = small(method);
        const std::string one = picture(settings);
        for (unsigned threads : {2u, 7u}) {
            settings.threads = threads;
            CHECK(picture(settings) == one);
        }
    }
}

TEST_CASE("the same seed gives the same bytes, another seed others") {
    for (Method method : all_methods) {
        RenderSettings settings = small(method);
        const std::string first = picture(settings);
        CHECK(picture(settings) == first);
        settings.seed = 2;
        CHECK(picture(settings) != first);
    }
}

TEST_CASE("a white furnace shows the albedo: MC within 5 standard errors, BMC within 3 predicted errors") {
    const EnvironmentMap white(1, 1, {1, 1, 1});
    Scene scene = sphere_scene();
    scene.rectangle.x_max = scene.rectangle.x_min;  // no area: every point of the sphere sees the environment only
    for (Method method : all_methods) {
        const RenderSettings settings = small(method);
        const Image image = render(scene, white, Sobolev(), settings);
        // cos(theta) on uniform directions has variance 1/12 over density 1 / 2 pi, and albedo / pi in front.
        double bound = 5 * 0.8 / pi * 2 * pi * std::sqrt(1.0 / 12 / 40);
        if (method != Method::mc) {
            Random random(1, 0);
            const GaussianProcess process(Sobolev(), 0.01, uniform_directions(40, random));
            std::vector<double> cosines;
            for (const Vec3& direction : process.directions()) cosines.push_back(direction.y);
            bound = 3 * 0.8 / pi * process.standard_error(cosines);
        }
        int pixels = 0;
        double sum = 0;
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x) {
                const auto hit = intersect(scene, Camera{40, 40}.ray(x, y));
                if (!hit) continue;
                CHECK(std::fabs(image(x, y).y - 0.8) < bound);
                sum += image(x, y).y;
                ++pixels;
            }
        REQUIRE(pixels > 500);
        CHECK(std::fabs(sum / pixels - 0.8) < bound);
    }
}

TEST_CASE(
    "a uniform environment is rendered exactly by every prior with the mean uniform, where nothing is in the way") {
    const EnvironmentMap light(1, 1, {0.75, 0.5, 0.25});
    Scene scene = sphere_scene();
    scene.rectangle.x_max = scene.rectangle.x_min;
    for (Method method : {Method::direct, Method::single, Method::rotated, Method::pool})
        for (const KnownPart known : {KnownPart::nothing, KnownPart::cosine})
            for (const Placement placement : {Placement::uniform, Placement::cosine_fibonacci}) {
                RenderSettings settings = small(method);
                settings.prior = {known, PriorMean::uniform};
                settings.placement = placement;
                settings.samples = 10;
                const Image image = render(scene, light, Sobolev(), settings);
                for (int y = 0; y < 40; ++y)
                    for (int x = 0; x < 40; ++x) {
                        if (!intersect(scene, Camera{40, 40}.ray(x, y))) continue;
                        // 1e-12 before the image rounds to float; 0.75 * 0.8 as a float is within 3e-8 of it.
                        CHECK(std::fabs(image(x, y).x - static_cast<double>(0.6f)) < 6e-8);
                        CHECK(std::fabs(image(x, y).y - static_cast<double>(0.4f)) < 6e-8);
                        CHECK(std::fabs(image(x, y).z - static_cast<double>(0.2f)) < 6e-8);
                    }
            }
}

TEST_CASE("knowing the cosine and placing the samples by it halves the error of the default") {
    const EnvironmentMap environment = built_in_environment();
    const Image truth = dense_quadrature(environment);
    RenderSettings settings = small(Method::pool);
    const double plain = error_of(render(sphere_scene(), environment, Sobolev(), settings), truth).rmse;
    settings.prior.known = KnownPart::cosine;
    settings.placement = Placement::cosine_fibonacci;
    const double informed = error_of(render(sphere_scene(), environment, Sobolev(), settings), truth).rmse;
    CHECK(informed / plain < 0.55);
}

TEST_CASE("every method tends to the same picture, and BMC is nearer to it than MC") {
    const EnvironmentMap environment = built_in_environment();
    const Image truth = dense_quadrature(environment);
    const Image mc = render(sphere_scene(), environment, Sobolev(), small(Method::mc));
    const double mc_error = error_of(mc, truth).rmse;
    for (Method method : {Method::direct, Method::rotated, Method::pool}) {
        const Image image = render(sphere_scene(), environment, Sobolev(), small(method));
        CHECK(error_of(image, truth).rmse / mc_error < 0.75);
    }
    // The mean of 1062 pixels x 40 samples; 5 % covers the bias that a zero prior mean has at 40 samples and one shared
    // rule.
    for (Method method : all_methods) {
        const Image image = render(sphere_scene(), environment, Sobolev(), small(method));
        CHECK(std::fabs(error_of(image, truth).brightness) < 0.05);
    }
}

TEST_CASE("a pixel that shows no object shows the environment") {
    const EnvironmentMap environment = built_in_environment();
    const Image image = render(sphere_scene(), environment, Sobolev(), small(Method::pool));
    const Color seen = environment.radiance(Camera{40, 40}.ray(0, 0).direction);
    CHECK(image(0, 0).x == seen.x);
    CHECK(image(0, 0).z == seen.z);
}

TEST_CASE("light that the other object blocks is missing: the rectangle is dark under the sphere") {
    const EnvironmentMap white(1, 1, {1, 1, 1});
    RenderSettings settings = small(Method::mc);
    settings.samples = 1000;
    const Image image = render(sphere_scene(), white, Sobolev(), settings);
    const Camera camera{40, 40};
    double nearest = 10, darkest = 1;
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            const auto hit = intersect(sphere_scene(), camera.ray(x, y));
            if (!hit || hit->object != Object::rectangle) continue;
            const double distance = length(hit->point - Vec3{0, -2, -5});
            if (distance >= nearest) continue;
            nearest = distance;
            darkest = image(x, y).y / 0.8;
        }
    // At distance d from the contact point the sphere of radius 2 covers sin^2 = 4 / (4 + d^2) of its directions; its
    // cosine to the normal is 2 / sqrt(4 + d^2), so a whole-sphere form factor 4 / (4 + d^2) * 2 / sqrt(4 + d^2) is an
    // upper bound of what is blocked, and half of it a lower one.
    const double factor = 8 / std::pow(4 + nearest * nearest, 1.5);
    CHECK(darkest < 1 - factor / 2);
    CHECK(darkest > 1 - factor - 0.05);
}

TEST_CASE("an error in a thread reaches the caller") {
    RenderSettings settings = small(Method::direct);
    settings.noise = 0;
    settings.samples = 400;
    settings.threads = 2;
    CHECK_THROWS_AS(render(sphere_scene(), built_in_environment(), SquaredExponential(5), settings),
                    NotPositiveDefinite);
}

TEST_CASE("progress reaches the end") {
    double last = 0;
    RenderSettings settings = small(Method::pool);
    render(sphere_scene(), built_in_environment(), Sobolev(), settings, [&](double done) {
        CHECK(done > last);
        last = done;
    });
    CHECK(last == 1);
}
