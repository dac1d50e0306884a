#include "beyond/reports/picture_error.h"

namespace bmc {
Image dense_truth(const EnvironmentMap& environment, PictureSettings settings, std::size_t samples) {
    settings.method = Method::mc;
    settings.placement = Placement::cosine_fibonacci;
    settings.samples = samples;
    const Scene scene = sphere_scene();
    const Sun sun(environment, 4);  // with the edge of a disc, which a lattice would seldom meet
    const EnvironmentMap sky = sun.sky();
    const Shade of_sky = reflected_environment(scene, sky, PixelRules(settings));
    return render(scene, environment, settings, [&](const Hit& hit, int x, int y) {
        Random random = pixel_stream(settings, x, y);
        const Color of_sun = light_of_sun(scene, sun, hit, sun.empty() ? 0 : samples, random).visible;
        return of_sky(hit, x, y) + sun.light() / (portable::pi * static_cast<double>(samples)) * (hit.albedo * of_sun);
    });
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

double coverage(const Image& image, const Image& truth, const Image& predicted) {
    double within = 0, all = 0;
    for_each_hit(sphere_scene(), {image.width, image.height}, [&](int x, int y, const Hit&) {
        const Color error = image(x, y) - truth(x, y), most = 2 * predicted(x, y);
        within += (std::fabs(error.x) <= most.x) + (std::fabs(error.y) <= most.y) + (std::fabs(error.z) <= most.z);
        all += 3;
    });
    return within / all;
}
}  // namespace bmc
