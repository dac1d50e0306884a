#include "beyond/known_light_cost.h"
#include "test.h"

using namespace bmc::beyond;

static Image truth_with_sun(const EnvironmentMap& map, RenderSettings settings, std::size_t samples) {
    settings.samples = samples;
    return render(map, settings, sun_shader(map, settings, samples));
}

TEST_CASE("the dense truth gives a lamp that is no sun its own rays") {
    const RenderSettings settings = small_picture(Method::mc, 1, 10);
    EnvironmentMap lamp = even_map(64, 32, 1);
    lamp.set(20, 8, {50, 50, 50});
    CHECK(image_error(truth_with_sun(lamp, settings, 1000), truth_with_sun(lamp, settings, 10000)).rmse < 0.003);
}

// Equal weights on the cosine lattice, which the better picture has, are the best that the picture itself can have.
TEST_CASE("a better picture has at most half of the error of the best, under a sun, too") {
    for (const EnvironmentMap& map : {coloured_map(16, 9), sunny_map()}) {
        const RenderSettings settings = small_picture(Method::mc, 20, 16, {PointSet::fibonacci, KnownPart::cosine});
        const Image truth = truth_with_sun(map, settings, 2000),
                    better = render(map, settings, better_shader({map, false, 1}, settings));
        const PictureCost equal = compared_picture(map, Method::mc, 1, {PointSet::fibonacci, KnownPart::cosine});
        CAPTURE(map.width);
        CHECK(image_error(better, truth).rmse < 0.5 * image_error(equal.image(settings), truth).rmse);
    }
}

// Under a sun and a sky, of which about half of the samples see one each: the mean is right within 5 standard errors.
TEST_CASE("multiple importance sampling is right on average, and as a quotient it has half of the error") {
    const EnvironmentMap map = sunny_map();
    RenderSettings settings = small_picture(Method::mc, 11, 10, {PointSet::stratified, KnownPart::cosine});
    const Image truth = truth_with_sun(map, settings, 10000);
    const Sun all(map, 0);
    Statistics brightness;
    RootMeanSquare error, quotients_error;
    const EnvironmentLight known(map, true, 1);
    for (settings.seed = 1; settings.seed <= 100; ++settings.seed) {
        const ImageError sums = image_error(render(map, settings, mis_shader({map, false, 1}, all, settings)), truth);
        brightness.add(sums.brightness);
        error.add(sums.rmse);
        quotients_error.add(image_error(render(map, settings, mis_shader(known, all, settings)), truth).rmse);
    }
    CHECK(std::fabs(brightness.mean) < 5 * brightness.standard_error());
    CHECK(brightness.standard_error() < 0.003);
    CHECK(quotients_error.value() < 0.5 * error.value());
}

TEST_CASE("known-light refuses a light whose texels would fill the memory") {
    const EnvironmentMap large(1 << 13, (1 << 10) + 1);
    CHECK(message_of([&] { KnownLightReport().table("large.hdr", large); }) ==
          Containing{"large.hdr has 8192 x 1025 texels, but known-light takes at most 8388608"});
}
