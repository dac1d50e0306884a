#include "scene/desert.h"
#include "scene/pilot.h"
#include "scene/render.h"

#include "experiments/picture_error.h"

#include <doctest/doctest.h>

#include <cmath>

namespace {

const Scene scene = sphere_scene();

RenderSettings small(KnownPart known, std::size_t samples, int size = 60) {
    RenderSettings settings;
    settings.known = known;
    if (known != KnownPart::nothing) settings.placement = Placement::cosine_fibonacci;
    settings.samples = samples;
    settings.width = settings.height = size;
    settings.threads = 2;
    return settings;
}

Image errors_of(const Light& light, RenderSettings settings) {
    settings.show = Show::error;
    return render(scene, light, settings);
}

double pilot_rmse(const Light& light, RenderSettings settings) {
    settings.show = Show::error;
    PixelRules rules(settings, settings.known == KnownPart::light ? &light.averages() : nullptr);
    for (std::size_t i = rules.shared_count(); i > 0; --i) rules.make_shared_rule();
    return run_pilot(scene, light, settings, rules).rmse;
}

Image dense_quadrature(const Light& light, RenderSettings settings) {
    settings.method = Method::mc;
    settings.placement = Placement::fibonacci;
    settings.known = KnownPart::nothing;
    settings.samples = 20000;
    return render(scene, light, settings);
}

}  // namespace

// Over twenty seeds the ratios are RATIOS, the shares SHARES.
TEST_CASE("a picture predicts its RMSE to 30 %, and 19 of 20 errors lie within two predicted ones") {
    const EnvironmentMap desert = built_in_environment();
    const Light light(desert);
    const Truth truth = truth_of(dense_quadrature(light, small(KnownPart::nothing, 1)));
    for (const KnownPart known : {KnownPart::nothing, KnownPart::cosine, KnownPart::light})
        for (const std::size_t samples : {10u, 40u}) {
            const RenderSettings settings = small(known, samples);
            const Image picture = render(scene, light, settings), errors = errors_of(light, settings);
            const double predicted = root_mean_square(errors, object_pixels(scene, 60, 60));
            const double ratio = predicted / image_error(picture, truth).rmse;
            const double within = share_within_two(picture, truth, errors);
            CAPTURE(samples);
            CAPTURE(ratio);
            CAPTURE(within);
            CHECK(ratio > 0.85);
            CHECK(ratio < 1.35);
            CHECK(within > 0.92);
            CHECK(within < 0.99);
        }
}

TEST_CASE("every method predicts, and fresh processes predict what pools do") {
    const EnvironmentMap desert = built_in_environment();
    const Light light(desert);
    RenderSettings settings = small(KnownPart::nothing, 20, 40);
    const double pool = pilot_rmse(light, settings);
    for (const Method method : {Method::direct, Method::rotated, Method::single}) {
        settings.method = method;
        CHECK(std::fabs(pilot_rmse(light, settings) / pool - 1) <
              0.25);  // one rule of 20 directions is more or less lucky
    }
    settings.method = Method::mc;
    const double mc = pilot_rmse(light, settings);
    CHECK(mc > 1.5 * pool);
    settings.samples = 80;
    CHECK(std::fabs(pilot_rmse(light, settings) / mc - 0.5) < 0.02);
}

TEST_CASE("a pilot of a small picture is the whole, of a large one every k-th pixel") {
    const EnvironmentMap desert = built_in_environment();
    const Light light(desert);
    RenderSettings settings = small(KnownPart::light, 20);
    const double whole = root_mean_square(errors_of(light, settings), object_pixels(scene, 60, 60));
    CHECK(std::fabs(pilot_rmse(light, settings) / whole - 1) < 1e-6);  // the picture has single precision
    settings.width = settings.height = 200;
    const double large = root_mean_square(errors_of(light, settings), object_pixels(scene, 200, 200));
    const double pilot = pilot_rmse(light, settings);
    CHECK(pilot != large);
    CHECK(std::fabs(pilot / large - 1) < 0.05);
}

TEST_CASE("errors are 0 where no object is, and the same for every number of threads") {
    const EnvironmentMap desert = built_in_environment();
    const Light light(desert);
    RenderSettings settings = small(KnownPart::cosine, 10, 40);
    const Image errors = errors_of(light, settings);
    const Truth truth = truth_of(errors);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) CHECK((errors(x, y).x > 0) == truth.shows_object(x, y));
    settings.threads = 7;
    CHECK(to_pfm(errors_of(light, settings)) == to_pfm(errors));
}

TEST_CASE("as many samples are chosen as have the RMSE that is asked for") {
    const EnvironmentMap desert = built_in_environment();
    const Light light(desert);
    for (const KnownPart known : {KnownPart::nothing, KnownPart::light})
        for (const double target : {0.02, 0.01}) {
            RenderSettings settings = small(known, 1);
            const ChosenSamples chosen = samples_for(target, 4096, scene, light, settings);
            CHECK(chosen.rmse <= target);
            const double n = static_cast<double>(chosen.samples);
            CHECK(chosen.rmse * n / (n - 1) > target);  // the RMSE falls more slowly than 1 / n
            settings.samples = chosen.samples;
            const double predicted = pilot_rmse(light, settings);
            CHECK(predicted > 0.85 * target);
            CHECK(predicted < 1.15 * target);
        }
}

TEST_CASE("an RMSE that any samples have takes two, and one that no samples have is refused with what they have") {
    const EnvironmentMap desert = built_in_environment();
    const Light light(desert);
    const RenderSettings settings = small(KnownPart::nothing, 1, 20);
    CHECK(samples_for(1, 4096, scene, light, settings).samples == 2);
    CHECK_THROWS_WITH_AS(samples_for(1e-9, 8, scene, light, settings),
                         "an RMSE of 1e-09 is out of reach: 8 samples, the most allowed, have one of 0.057",
                         std::runtime_error);
    const EnvironmentMap black(1, 1, {0, 0, 0});
    CHECK(samples_for(1e-9, 4096, scene, black, settings).rmse == 0);
}

TEST_CASE("errors in grey: the root mean square of the colours, white as it is asked for") {
    Image errors(2, 1);
    errors.set(0, 0, {3, 6, 6});
    const Image grey = grey_scale(errors, std::sqrt(27.0));
    CHECK(std::fabs(grey(0, 0).x - 1) < 1e-6);
    CHECK(grey(0, 0).z == grey(0, 0).x);
    CHECK(grey(1, 0).y == 0);
    CHECK(grey_scale(Image(1, 1), 0)(0, 0).x == 0);
    CHECK(root_mean_square(errors, 1) == std::sqrt(27.0));
}
