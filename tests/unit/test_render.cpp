#include "test.h"

#include <cmath>

using portable::pi;

namespace {

std::string picture(const RenderSettings& settings) { return to_pfm(render(sphere_scene(), desert, settings)); }

// The light that a point reflects as one would first write it, in double precision and from a rule as it is.
Color plain_light(const Scene& scene, const EnvironmentMap& environment, const Hit& hit, const QuadratureRule& rule,
                  const Frame& frame) {
    Color sum;
    for (std::size_t i = 0; i < rule.weights.size(); ++i) {
        const Vec3 direction = frame.to_world(rule.directions[i]);
        if (is_shadowed(scene, hit, direction)) continue;
        sum = sum + rule.weights[i] * rule.directions[i].y / pi * environment.radiance(direction);
    }
    return {hit.albedo.x * sum.x, hit.albedo.y * sum.y, hit.albedo.z * sum.z};
}

// The picture of plain_light, with the random numbers that render draws: a pixel's own and those of the shared rules.
Image plain_picture(const EnvironmentMap& environment, const RenderSettings& settings) {
    const Scene scene = sphere_scene();
    const auto rule_of = [&](Random& random) {
        const DirectionSet set = place_directions(Placement::uniform, settings.samples, random);
        return settings.method == Method::mc ? monte_carlo_rule(set)
                                             : bayesian_rule(Sobolev(), settings.noise, set.directions);
    };
    std::vector<QuadratureRule> shared;
    for (std::uint64_t i = 0; i < settings.pool; ++i) {
        Random random(settings.seed, (std::uint64_t{1} << 63) + i);
        shared.push_back(rule_of(random));
    }
    Image image(settings.width, settings.height);
    for (int y = 0; y < settings.height; ++y)
        for (int x = 0; x < settings.width; ++x) {
            const Ray ray = Camera{settings.width, settings.height}.ray(x, y);
            const auto hit = intersect(scene, ray);
            Random random(settings.seed, static_cast<std::uint64_t>(y * settings.width + x));
            if (!hit) {
                image.set(x, y, environment.interpolated_radiance(ray.direction));
                continue;
            }
            Frame frame(hit->normal);
            if (settings.method == Method::mc || settings.method == Method::direct) {
                image.set(x, y, plain_light(scene, environment, *hit, rule_of(random), frame));
                continue;
            }
            std::size_t choice = 0;
            if (settings.method != Method::single) {
                const double u = random.uniform();
                const double turns = random.uniform();
                if (settings.method == Method::pool) choice = static_cast<std::size_t>(20 * u);
                frame = frame.rotated(turns);
            }
            image.set(x, y, plain_light(scene, environment, *hit, shared[choice], frame));
        }
    return image;
}

}  // namespace

TEST_CASE("the directions of a pixel are those that specification.md gives") {
    const auto hit = intersect(sphere_scene(), Camera{500, 500}.ray(0, 499));
    REQUIRE(hit.has_value());
    Random random(1, 499 * 500);
    const Frame frame(hit->normal);
    const std::vector<Vec3> local = uniform_directions(40, random);
    const Vec3 expected[] = {{-0.710549396, 0.566751086, -0.417028492},
                             {-0.015689316, 0.616979968, -0.786822448},
                             {-0.702922947, 0.613658490, 0.359614498}};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 difference = frame.to_world(local[i]) - expected[i];
        CHECK(std::sqrt(dot(difference, difference)) < 1e-9);
    }
}

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
        const Image image = render(scene, white, settings);
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

TEST_CASE("knowing the cosine and placing the samples by it halves the error of the default") {
    const Image truth = dense_picture(desert);
    RenderSettings settings = small(Method::pool);
    const double plain = error_of(render(sphere_scene(), desert, settings), truth).rmse;
    settings.known = KnownPart::cosine;
    settings.placement = Placement::cosine_fibonacci;
    const double informed = error_of(render(sphere_scene(), desert, settings), truth).rmse;
    CHECK(informed / plain < 0.55);
}

TEST_CASE("every method tends to the same picture, and BMC is nearer to it than MC") {
    const Image truth = dense_picture(desert);
    const Image mc = render(sphere_scene(), desert, small(Method::mc));
    const double mc_error = error_of(mc, truth).rmse;
    for (Method method : {Method::direct, Method::rotated, Method::pool}) {
        const Image image = render(sphere_scene(), desert, small(method));
        CHECK(error_of(image, truth).rmse / mc_error < 0.75);
    }
    // The mean of 1062 pixels x 40 samples; 5 % covers the bias that a zero prior mean has at 40 samples and one shared
    // rule.
    for (Method method : all_methods) {
        const Image image = render(sphere_scene(), desert, small(method));
        CHECK(std::fabs(error_of(image, truth).brightness) < 0.05);
    }
}

TEST_CASE("a pixel that shows no object shows the environment") {
    const Image image = render(sphere_scene(), desert, small(Method::pool));
    const Color seen = desert.interpolated_radiance(Camera{40, 40}.ray(0, 0).direction);
    CHECK(image(0, 0).x == static_cast<double>(static_cast<float>(seen.x)));
    CHECK(image(0, 0).z == static_cast<double>(static_cast<float>(seen.z)));
}

TEST_CASE("light that the other object blocks is missing: the rectangle is dark under the sphere") {
    const EnvironmentMap white(1, 1, {1, 1, 1});
    RenderSettings settings = small(Method::mc);
    settings.samples = 1000;
    const Image image = render(sphere_scene(), white, settings);
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
    settings.covariance = CovarianceFamily::squared_exponential;
    settings.length_scale = 5;
    settings.noise = 0;
    settings.samples = 400;
    settings.threads = 2;
    CHECK_THROWS_AS(render(sphere_scene(), desert, settings), NotPositiveDefinite);
}

TEST_CASE("a sphere under the rectangle lies in its shadow") {
    Scene scene = sphere_scene();
    scene.sphere.radius = 0.8;
    scene.rectangle.y = 1.2;
    RenderSettings settings = small(Method::mc);
    settings.width = settings.height = 160;
    settings.placement = Placement::fibonacci;
    settings.samples = 1000;
    const Color lit = render(scene, desert, settings)(81, 60);
    const auto hit = intersect(scene, Camera{160, 160}.ray(81, 60));
    REQUIRE(hit);
    Color truth;
    const Frame frame(hit->normal);
    for (const Vec3& local : fibonacci_directions(100000)) {
        const Vec3 direction = frame.to_world(local);
        if (!intersect(scene, {hit->point + 1e-9 * hit->normal, direction}))
            truth = truth + (hit->albedo.x * 2 / 100000 * local.y) * desert.radiance(direction);
    }
    // The sky that the rectangle hides would make 0.29, 0.32 and 0.45 of it. A lattice of 1000 samples errs by about
    // 0.003 where a shadow's edge cuts through it.
    CHECK(std::fabs(truth.x - 0.073) < 5e-4);
    CHECK(std::fabs(truth.z - 0.043) < 5e-4);
    CHECK(std::fabs(lit.x - truth.x) < 0.01);
    CHECK(std::fabs(lit.y - truth.y) < 0.01);
    CHECK(std::fabs(lit.z - truth.z) < 0.01);
}

// Single precision moves about one direction in 10,000 across a texel's edge; what it changes of a pixel seldom reaches
// half a unit of a byte. In 500 x 500 pixels 3 to 10 of 250,000 differ, 31 to 49 under a map of high contrast.
TEST_CASE("single precision changes the bytes of at most 3 pixels in 10,000, whatever the method") {
    for (const Method method : all_methods) {
        RenderSettings settings = small(method);
        settings.width = settings.height = 100;
        const std::string fast = to_ppm(render(sphere_scene(), desert, settings));
        const std::string plain = to_ppm(plain_picture(desert, settings));
        REQUIRE(fast.size() == plain.size());
        int different = 0;
        for (std::size_t i = fast.size() - 30000; i < fast.size(); i += 3)
            different += fast.compare(i, 3, plain, i, 3) != 0;
        CHECK(different <= 3);
    }
}

TEST_CASE("progress tells of every rule of a pool and of the rows, without going back, and of the end once") {
    RenderSettings settings = small(Method::pool);
    for (const unsigned threads : {1u, 2u}) {
        settings.threads = threads;
        double last = 0;
        std::size_t calls = 0;
        render(sphere_scene(), desert, settings, [&](double done) {
            CHECK(done > last);
            last = done;
            if (++calls <= settings.pool) CHECK(std::fabs(done - static_cast<double>(calls) / 60) < 1e-15);
        });
        CHECK(calls > settings.pool);
        if (threads == 1) CHECK(calls == settings.pool + 40);
        CHECK(last == 1);
    }
}
