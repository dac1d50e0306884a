#include "scene/picture_request.h"
#include "test.h"

TEST_CASE("the options of a picture set its members, in the ranges of a picture") {
    PictureRequest request;
    const RenderSettings& s = request.settings;
    CHECK(s.threads >= 1);
    check_ranges(request.options(),
                 {"--size=8192", "--size=5x6", "--samples=1000000", "--pool=1000", "--threads=256", "--exposure=100",
                  "--exposure=-100", "--method=rotated", "--environment=a.hdr", "--format=pfm", "--noise=0.5"},
                 {"--size=8193", "--size=5x", "--size=x5", "--size=5x5x5", "--size=0", "--size=5x8193",
                  "--samples=1000001", "--pool=1001", "--threads=257", "--exposure=100.1", "--exposure=-100.1"});
    CHECK(s.method == Method::rotated);
    CHECK(std::vector{s.samples, s.pool} == std::vector<std::size_t>{1000000, 1000});
    CHECK(Numbers{s.width + 0.0, s.height + 0.0, s.threads + 0.0} == Numbers{5, 6, 256});
    CHECK(Numbers{s.noise, request.exposure} == Numbers{0.5, -100});
    CHECK(request.environment == "a.hdr");
    CHECK(request.format == Format::pfm);
    parse({"--size=7"}, request.options());
    CHECK(s.width == 7);
    CHECK(s.height == 7);
}

TEST_CASE("more samples than a process can have are for Monte Carlo on a lattice") {
    PictureRequest request;
    for (const auto& row : method_names)
        for (const Placement placement : {Placement::uniform, Placement::fibonacci})
            for (const std::size_t samples : {4096u, 4097u}) {
                request.settings = small_picture(row.second, samples, 12, placement);
                const bool mc = row.second == Method::mc, possible = samples == 4096 || (mc && is_lattice(placement));
                CAPTURE(samples);
                CHECK_MESSAGE(message_of([&] { request.require_possible(); }).empty() == possible, row.first);
            }
}

TEST_CASE("a request is the light that the practice's scene reflects") {
    const EnvironmentMap map = coloured_map(16, 9);
    const Scene scene = sphere_scene();
    PictureRequest request;
    request.settings = small_picture(Method::pool, 7);
    const PixelRules rules(request.settings);
    CHECK(first_difference(request.image(map).pixels,
                           render(scene, map, request.settings, environment_shader(scene, map, rules)).pixels) == "");
}

TEST_CASE("a PPM has 2^exposure times the light of the picture, a PFM the light itself") {
    PictureRequest request;
    request.exposure = -2;
    Image image(2, 1);
    image.pixels = {{1, 0.5, 3}, {0.25, 0, 4}};
    request.format = Format::pfm;
    CHECK(request.file(image) == encode(image, Format::pfm));
    request.format = Format::ppm;
    std::string file;
    stderr_of([&] { file = request.file(image); });
    for (Color& pixel : image.pixels) pixel = 0.25 * pixel;
    CHECK(file == encode(image, Format::ppm));
}

TEST_CASE("more than a tenth of the objects' pixels above white gives a warning") {
    const auto warning = [](double grey, double black_fraction, double exposure) {
        PictureRequest request;
        request.exposure = exposure;
        Image image(50, 50);
        double seen = 0, objects = 0;
        for_each_hit(sphere_scene(), {50, 50}, [&](int, int, const Hit&) { ++objects; });
        for_each_hit(sphere_scene(), {50, 50}, [&](int x, int y, const Hit&) {
            if (++seen > black_fraction * objects) image(x, y) = {0, grey, 0};
        });
        return stderr_of([&] { request.file(image); });
    };
    CHECK(warning(1, 0, 0) == "");
    CHECK(warning(8, 0.91, 0) == "");
    CHECK(warning(8, 0.89, 0) ==
          Containing{"brighter than white; --exposure -3.0 makes the brightest hundredth white"});
    CHECK(warning(4, 0, 1.5) == Containing{"--exposure -2.0 "});
}

TEST_CASE("of less than a hundred pixels the brightest is made white") {
    Image rising(8, 8);
    double stops = 0;
    for_each_hit(sphere_scene(), {8, 8}, [&](int x, int y, const Hit&) { rising(x, y).x = std::exp2(++stops); });
    CHECK(stderr_of([&] { PictureRequest().file(rising); }) == Containing{formatted("--exposure %.1f ", -stops)});
}

// The noise passes both thresholds in small steps.
TEST_CASE("weights whose sizes sum to S > 2, or that sum to less than half, give a warning") {
    RenderSettings settings = small_picture(Method::single, 85);
    settings.covariance = CovarianceFamily::squared_exponential;
    int close_to_2 = 0, close_to_half = 0;
    for (settings.noise = 30; settings.noise > 1e-5; settings.noise *= 0.85) {
        CAPTURE(settings.noise);
        const PixelRules rules(settings);
        const QuadratureRule& rule = *rules.shared()[0];
        const double s = stability_constant(rule), sum = relative_weight_sum(rule);
        const std::string warning = stderr_of([&] { warn_of_weights(rules); });
        CHECK(contains(warning, formatted("sizes of a rule's weights sum to %.3g times", s)) == (s > 2));
        CHECK(contains(warning, formatted("a rule's weights sum to %.3g times", sum)) == (s <= 2 && sum < 0.5));
        close_to_2 += std::fabs(s - 2) < 0.3;
        close_to_half += std::fabs(sum - 0.5) < 0.1;
    }
    CHECK(close_to_2 >= 2);
    CHECK(close_to_half >= 2);
}
