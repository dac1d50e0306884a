#include "experiments/picture_error.h"

#include <cmath>

std::vector<bool> object_mask(const Scene& scene, int width, int height) {
    const Camera camera{width, height};
    std::vector<bool> mask;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) mask.push_back(intersect(scene, camera.ray(x, y)).has_value());
    return mask;
}

ImageError image_error(const std::vector<bool>& mask, const Image& image, const Image& truth) {
    double count = 0, sum = 0, true_sum = 0, squares = 0, products = 0, pair_squares = 0;
    std::size_t pixel = 0;
    for (int y = 0; y < truth.height(); ++y)
        for (int x = 0; x < truth.width(); ++x, ++pixel) {
            if (!mask[pixel]) continue;
            const Color here = image(x, y), true_here = truth(x, y), error = here - true_here;
            const double squared = dot(error, error);
            count += 3;
            sum += here.x + here.y + here.z;
            true_sum += true_here.x + true_here.y + true_here.z;
            squares += squared;
            if (x + 1 == truth.width() || !mask[pixel + 1]) continue;
            const Color next = image(x + 1, y) - truth(x + 1, y);
            products += dot(error, next);
            pair_squares += (squared + dot(next, next)) / 2;
        }
    return {std::sqrt(squares / count), pair_squares > 0 ? products / pair_squares : 0, sum / true_sum - 1};
}

double share_within_two(const std::vector<bool>& mask, const Image& image, const Image& truth, const Image& predicted) {
    double within = 0, all = 0;
    std::size_t pixel = 0;
    for (int y = 0; y < truth.height(); ++y)
        for (int x = 0; x < truth.width(); ++x) {
            if (!mask[pixel++]) continue;
            const Color error = image(x, y) - truth(x, y), most = 2 * predicted(x, y);
            within += (std::fabs(error.x) <= most.x) + (std::fabs(error.y) <= most.y) + (std::fabs(error.z) <= most.z);
            all += 3;
        }
    return within / all;
}
