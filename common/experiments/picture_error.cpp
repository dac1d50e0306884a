#include "experiments/picture_error.h"

namespace bmc {
Image reference_image(const EnvironmentMap& light, RenderSettings settings, std::size_t samples) {
    settings.method = Method::mc;
    settings.placement = Placement::cosine_fibonacci;
    settings.samples = samples;
    return picture(light, settings);
}

ImageError image_error(const Image& image, const Image& truth) {
    const Scene scene = sphere_scene();
    const Camera camera{image.width, image.height};
    double count = 0, true_sum = 0, squares = 0, products = 0, pair_squares = 0;
    Color sum;
    for_each_hit(scene, camera, [&](int x, int y, const Hit&) {
        const Color error = image(x, y) - truth(x, y);
        count += 1;
        sum += error;
        true_sum += dot(truth(x, y), {1, 1, 1});
        squares += dot(error, error);
    });
    const Color mean = 1 / count * sum;
    for_each_hit(scene, camera, [&](int x, int y, const Hit&) {
        if (x + 1 == image.width || !intersect(scene, camera.ray(x + 1, y))) return;
        const Color here = image(x, y) - truth(x, y) - mean, next = image(x + 1, y) - truth(x + 1, y) - mean;
        products += dot(here, next);
        pair_squares += (dot(here, here) + dot(next, next)) / 2;
    });
    return {std::sqrt(squares / (3 * count)), pair_squares > 0 ? products / pair_squares : 0,
            (sum.x + sum.y + sum.z) / true_sum};
}
}  // namespace bmc
