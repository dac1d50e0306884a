#include "scene/picture_request.h"
#include "test.h"

static void check_ranges(const Options& options, const std::vector<std::string>& within,
                         const std::vector<std::string>& beyond) {
    for (const std::string& word : within) CHECK_MESSAGE(message_of([&] { parse({word}, options); }) == "", word);
    for (const std::string& word : beyond) CHECK_THROWS_AS_MESSAGE(parse({word}, options), std::invalid_argument, word);
}

TEST_CASE("the options of a model set its members, in the ranges that a process can have") {
    ModelSettings s;
    const Options options = model_options(s);
    check_ranges(options,
                 {"--smoothness=1.001", "--length-scale=0.05", "--length-scale=1e6", "--noise=0", "--seed=0",
                  "--smoothness=1.999", "--noise=1000", "--seed=18446744073709551615",
                  "--covariance=squared-exponential", "--known=cosine", "--placement=cosine-fibonacci"},
                 {"--smoothness=1.0005", "--smoothness=1.9995", "--length-scale=0.0499", "--length-scale=1.1e6",
                  "--noise=-1e-9", "--noise=1001", "--seed=-1", "--known=all"});
    CHECK((s.covariance == CovarianceFamily::squared_exponential && s.smoothness == 1.999 && s.length_scale == 1e6));
    CHECK((s.noise == 1000 && s.known == Known::cosine && s.placement == Placement::cosine_fibonacci &&
           s.seed == UINT64_MAX));
}

TEST_CASE("the options of a picture set its members, in the ranges that a picture can have") {
    PictureRequest request;
    const RenderSettings& s = request.settings;
    CHECK(s.threads >= 1);
    check_ranges(request.options(),
                 {"--size=8192", "--size=5x6", "--samples=1000000", "--pool=1000", "--threads=256", "--exposure=100",
                  "--exposure=-100", "--method=rotated", "--environment=a.hdr", "--format=pfm", "--noise=0.5"},
                 {"--size=8193", "--size=5x", "--size=x5", "--size=5x5x5", "--size=0", "--size=5x8193",
                  "--samples=1000001", "--pool=1001", "--threads=257", "--exposure=100.1", "--exposure=-100.1"});
    CHECK((s.method == Method::rotated && s.samples == 1000000 && s.pool == 1000 && s.width == 5 && s.height == 6));
    CHECK((s.threads == 256 && s.noise == 0.5 && request.environment == "a.hdr" && request.exposure == -100));
    CHECK(request.format == Format::pfm);
    parse({"--size=7"}, request.options());
    CHECK((s.width == 7 && s.height == 7));
}

TEST_CASE("more samples than a process can have are for Monte Carlo on a lattice") {
    PictureRequest request;
    for (const auto& row : method_names)
        for (const Placement placement : {Placement::uniform, Placement::fibonacci})
            for (const std::size_t samples : {4096u, 4097u}) {
                request.settings = small_picture(row.second, samples, 12, placement);
                const bool mc = row.second == Method::mc, possible = samples == 4096 || (mc && is_lattice(placement));
                CHECK(message_of([&] { request.require_possible(); }).empty() == possible);
            }
}

TEST_CASE("a request is the light that the practice's scene reflects; a PPM has 2^exposure times as much") {
    const EnvironmentMap map = coloured_map(16, 9);
    const Scene scene = sphere_scene();
    PictureRequest request;
    request.settings = small_picture(Method::pool, 7);
    request.exposure = -2;
    Image image = render(scene, map, request.settings, environment_shader(scene, map, PixelRules(request.settings)));
    CHECK(same(request.image(map).pixels, image.pixels));
    request.format = Format::pfm;
    CHECK(request.file(image) == encode(image, Format::pfm));
    request.format = Format::ppm;
    std::string file;
    stderr_of([&] { file = request.file(image); });
    for (Color& pixel : image.pixels) pixel = 0.25 * pixel;
    CHECK(file == encode(image, Format::ppm));
}

TEST_CASE("more than a tenth of the objects' pixels above white warns, with the exposure that makes them white") {
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
    CHECK((warning(1, 0, 0) == "" && warning(8, 0.91, 0) == ""));
    CHECK(contains(warning(8, 0.89, 0), "brighter than white; --exposure -3.0 makes the brightest hundredth white"));
    CHECK(contains(warning(4, 0, 1.5), "--exposure -2.0 "));
}

// The noise passes both thresholds in small steps.
TEST_CASE("weights whose sizes sum to more than twice the integral, or that sum to less than half, give a warning") {
    RenderSettings settings = small_picture(Method::single, 85);
    settings.covariance = CovarianceFamily::squared_exponential;
    int close_to_2 = 0, close_to_half = 0;
    for (settings.noise = 30; settings.noise > 1e-5; settings.noise *= 0.85) {
        const PixelRules rules(settings);
        const QuadratureRule& rule = *rules.shared()[0];
        const double s = stability_constant(rule), sum = relative_weight_sum(rule);
        const std::string warning = stderr_of([&] { warn_of_weights(rules); });
        CHECK(contains(warning, formatted("sizes of a rule's weights sum to %.3g times", s)) == (s > 2));
        CHECK(contains(warning, formatted("a rule's weights sum to %.3g times", sum)) == (s <= 2 && sum < 0.5));
        close_to_2 += std::fabs(s - 2) < 0.3;
        close_to_half += std::fabs(sum - 0.5) < 0.1;
    }
    CHECK((close_to_2 >= 2 && close_to_half >= 2));
}
