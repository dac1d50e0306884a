#include "scene/pixel_rules.h"
#include "test.h"

TEST_CASE("a pixel's random stream has the number of the pixel, row after row") {
    RenderSettings settings = small_picture(Method::mc, 1, 1 << 17);
    settings.height = 70000;
    settings.seed = 5;
    CHECK(pixel_stream(settings, 3, 1 << 16).bits() == Random(5, (std::uint64_t{1} << 33) + 3).bits());
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
