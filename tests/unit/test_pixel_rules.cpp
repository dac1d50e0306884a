#include "scene/pixel_rules.h"
#include "test.h"

TEST_CASE("a pixel's random stream has the number of the pixel, row after row") {
    RenderSettings settings = small_picture(Method::mc, 1, 1 << 17);
    settings.height = 70000;
    settings.seed = 5;
    CHECK(pixel_stream(settings, 3, 1 << 16).bits() == Random(5, (std::uint64_t{1} << 33) + 3).bits());
}

TEST_CASE("a pixel has a fresh rule, a shared one, a turned one, or a chosen and turned one") {
    const Vec3 normal = normalize({0.3, -0.5, 0.8});
    for (const auto& [method_name, method] : named<Method>(method_names))
        for (const Placement placement : {Placement::uniform, Placement::cosine_fibonacci})
            for (std::uint64_t pixel = 0; pixel < 9; ++pixel) {
                const PixelRules rules(small_picture(method, 5, 12, placement, Known::cosine));
                Random drawn(1, pixel), here(1, pixel);
                const OrientedRule oriented = rules.rule_for(normal, drawn);
                Frame frame(normal);
                const std::string name = method_name;
                INFO(name);
                if (rules.shared().empty()) {
                    CHECK(oriented.rule->directions == place_directions(placement, 5, here).directions);
                } else {
                    const double u = method == Method::pool ? here.uniform() : 0;
                    if (method != Method::single) frame = frame.rotated(here.uniform());
                    CHECK(oriented.rule == rules.shared()[static_cast<std::size_t>(3 * u)]);
                }
                CHECK(oriented.frame.to_world({1, 2, 4}) == frame.to_world({1, 2, 4}));
                CHECK(drawn.bits() == here.bits());
            }
}

TEST_CASE("S is 1 for Monte Carlo, near 1 for rough covariances, far above for smooth ones") {
    const auto stability = [](const RenderSettings& settings) {
        return stability_constant(*PixelRules(settings).shared()[0]);
    };
    CHECK(std::fabs(stability(small_picture(Method::mc, 40, 12, Placement::cosine_fibonacci)) - 1) < 1e-14);
    for (const std::size_t samples : {5u, 10u, 40u, 160u})
        CHECK_MESSAGE(std::fabs(stability(small_picture(Method::pool, samples)) - 1) < 0.31, samples);
    RenderSettings smooth = small_picture(Method::pool, 85);
    smooth.covariance = CovarianceFamily::squared_exponential;
    CHECK(stability(smooth) < 1.31);  // noise 0.01
    smooth.noise = 0;
    CHECK(stability(smooth) > 20);
}
