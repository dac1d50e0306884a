#include "prediction/pilot.h"

#include "test.h"

namespace {

const Scene scene = sphere_scene();

ErrorOf error_under(const EnvironmentMap& light, const RenderSettings& settings) {
    return error_of_picture(scene, light, settings);
}

Image errors_of(const RenderSettings& settings) {
    return predicted_errors(scene, settings, error_under(desert, settings));
}

double pilot_rmse(const RenderSettings& settings) {
    return run_pilot(scene, settings, error_under(desert, settings)).rmse;
}

ChosenSamples chosen_for(double target, std::size_t most, const RenderSettings& settings,
                         const EnvironmentMap& light = desert) {
    return samples_for(target, 2, most, scene, settings,
                       [&](const RenderSettings& tried) { return error_under(light, tried); });
}

double rmse_of(const Image& errors) {
    return root_mean_square(errors, object_pixels(scene, {errors.width(), errors.height()}));
}

}  // namespace

// Over twenty seeds the ratios are 0.87 to 1.30, the coverages 0.90 to 0.98.
TEST_CASE("a picture predicts its RMSE to 30 %, and 19 of 20 errors lie within two predicted ones") {
    const Truth truth = truth_of(dense_picture(desert, 60));
    for (const KnownPart known : {KnownPart::nothing, KnownPart::cosine})
        for (const std::size_t samples : {10u, 40u}) {
            RenderSettings settings = small(Method::pool, samples, 60);
            settings.known = known;
            if (known == KnownPart::cosine) settings.placement = Placement::cosine_fibonacci;
            const Image image = render(scene, desert, settings), errors = errors_of(settings);
            check_prediction(image, errors, truth);
        }
}

TEST_CASE("every method predicts, and fresh processes predict what pools do") {
    const double pool = pilot_rmse(small(Method::pool, 20));
    for (const Method method : {Method::direct, Method::rotated, Method::single})
        CHECK(std::fabs(pilot_rmse(small(method, 20)) / pool - 1) <
              0.25);  // one rule of 20 directions is more or less lucky
    const double mc = pilot_rmse(small(Method::mc, 20));
    CHECK(mc > 1.5 * pool);
    CHECK(std::fabs(pilot_rmse(small(Method::mc, 80)) / mc - 0.5) < 0.02);
}

TEST_CASE("a pilot of a small picture is the whole, of a large one every k-th pixel") {
    RenderSettings settings = small(Method::pool, 20, 60);
    CHECK(std::fabs(pilot_rmse(settings) / rmse_of(errors_of(settings)) - 1) < 1e-6);  // floats in the picture
    settings.width = settings.height = 200;
    const double large = rmse_of(errors_of(settings)), pilot = pilot_rmse(settings);
    CHECK(pilot != large);
    CHECK(std::fabs(pilot / large - 1) < 0.05);
}

TEST_CASE("a pilot takes every k-th pixel of every k-th row, from the middle of the first k") {
    const RenderSettings settings = [] {
        RenderSettings wide = small(Method::mc, 2, 96);
        wide.width = 200;
        return wide;
    }();
    std::vector<Vec3> points, expected;
    run_pilot(scene, settings, [&](const Hit& hit, Random&) {
        points.push_back(hit.point);
        return PixelError{{}, {}, 2};
    });
    for (int y = 1; y < 96; y += 3)
        for (int x = 3; x < 200; x += 6)
            if (const auto hit = intersect(scene, Camera{200, 96}.ray(x, y))) expected.push_back(hit->point);
    CHECK(points.size() == expected.size());
    for (std::size_t i = 0; i < points.size(); ++i) CHECK(squared_distance(points[i], expected[i]) == 0);
}

TEST_CASE("pilots have at most eight rules that pixels share, and at most the most samples") {
    std::vector<RenderSettings> tried;
    const auto none = [&](const RenderSettings& settings) {
        tried.push_back(settings);
        return [](const Hit&, Random&) { return PixelError{{1, 1, 1}, {1, 1, 1}, 2}; };
    };
    for (const Method method : {Method::direct, Method::pool})
        CHECK_THROWS_AS(samples_for(0.1, 2, 100, scene, small(method, 1, 20), none), std::runtime_error);
    for (const RenderSettings& settings : tried) {
        CHECK(settings.method == Method::pool);
        CHECK(settings.pool == 8);
        CHECK(settings.samples <= 100);
    }
}

TEST_CASE("errors are 0 where no object is") {
    const Image errors = errors_of(small(Method::pool, 10));
    const Truth truth = truth_of(errors);
    for (std::size_t i = 0; i < errors.size(); ++i) CHECK((errors[i].x > 0) == truth.mask[i]);
}

TEST_CASE("as many samples are chosen as have the RMSE that is asked for") {
    for (const double target : {0.02, 0.01}) {
        RenderSettings settings = small(Method::pool, 1, 60);
        const ChosenSamples chosen = chosen_for(target, 4096, settings);
        CHECK(chosen.rmse <= target);
        const double n = static_cast<double>(chosen.samples);
        CHECK(chosen.rmse * n / (n - 1) > target);  // the RMSE falls more slowly than 1 / n
        settings.samples = chosen.samples;
        const double predicted = pilot_rmse(settings);
        CHECK(predicted > 0.85 * target);
        CHECK(predicted < 1.15 * target);
    }
}

TEST_CASE("an RMSE that any samples have takes two, and one that no samples have is refused with what they have") {
    const RenderSettings settings = small(Method::pool, 1, 20);
    CHECK(chosen_for(1, 4096, settings).samples == 2);
    CHECK_THROWS_WITH_AS(chosen_for(1e-9, 8, settings),
                         "an RMSE of 1e-09 is out of reach: 8 samples, the most allowed, have one of 0.057",
                         std::runtime_error);
    CHECK(chosen_for(1e-9, 4096, settings, even_map(1, 1, 0)).rmse == 0);
}
