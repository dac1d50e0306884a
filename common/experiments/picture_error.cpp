#include "experiments/picture_error.h"

#include "scene/sun.h"

#include <cmath>

namespace bmc {
Truth truth_of(Image image) {
    std::vector<bool> mask(image.size());
    for_each_hit(sphere_scene(), {image.width(), image.height()},
                 [&](int x, int y, const Hit&) { mask[static_cast<std::size_t>(y * image.width() + x)] = true; });
    return {std::move(image), std::move(mask)};
}

Truth dense_truth(const EnvironmentLight& light, PictureSettings settings, std::size_t samples) {
    settings.method = Method::mc;
    settings.placement = Placement::cosine_fibonacci;
    settings.samples = samples;
    const Scene scene = sphere_scene();
    const Sun sun(light.environment, 4);  // with the edge of a disc, which a lattice would seldom meet
    const EnvironmentMap sky = sun.sky();
    const Shade of_sky = reflected_environment(scene, sky, settings);
    return truth_of(render(scene, light.environment, settings, [&](const Hit& hit, int x, int y) {
        Random random = pixel_stream(settings, x, y);
        const Color of_sun = light_of_sun(scene, sun, hit, sun.empty() ? 0 : samples, random).visible;
        return of_sky(hit, x, y) + sun.light() / (portable::pi * static_cast<double>(samples)) * (hit.albedo * of_sun);
    }));
}

ImageError image_error(const Image& image, const Truth& truth) {
    double count = 0, true_sum = 0, squares = 0, products = 0, pair_squares = 0;
    Color sum;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (!truth.mask[i]) continue;
        const Color error = image[i] - truth.image[i];
        count += 1;
        sum += error;
        true_sum += dot(truth.image[i], {1, 1, 1});
        squares += dot(error, error);
    }
    const auto error = [&](int x, int y) { return image(x, y) - truth.image(x, y); };
    const Color mean = 1 / count * sum;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x + 1 < image.width(); ++x) {
            if (!truth.shows_object(x, y) || !truth.shows_object(x + 1, y)) continue;
            const Color here = error(x, y) - mean, next = error(x + 1, y) - mean;
            products += dot(here, next);
            pair_squares += (dot(here, here) + dot(next, next)) / 2;
        }
    return {std::sqrt(squares / (3 * count)), pair_squares > 0 ? products / pair_squares : 0,
            (sum.x + sum.y + sum.z) / true_sum};
}

double coverage(const Image& image, const Truth& truth, const Image& predicted) {
    double within = 0, all = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        if (!truth.mask[i]) continue;
        const Color error = image[i] - truth.image[i], most = 2 * predicted[i];
        within += (std::fabs(error.x) <= most.x) + (std::fabs(error.y) <= most.y) + (std::fabs(error.z) <= most.z);
        all += 3;
    }
    return within / all;
}
}  // namespace bmc
