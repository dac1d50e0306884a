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
    double count = 0, true_sum = 0, squares = 0, products = 0, pair_squares = 0;
    Color sum;
    const auto at_objects = [&](auto visit) {
        std::size_t pixel = 0;
        for (int y = 0; y < truth.height(); ++y)
            for (int x = 0; x < truth.width(); ++x, ++pixel)
                if (mask[pixel]) visit(x, y, image(x, y) - truth(x, y), x + 1 < truth.width() && mask[pixel + 1]);
    };
    at_objects([&](int x, int y, Color error, bool) {
        const Color true_here = truth(x, y);
        count += 1;
        sum = sum + error;
        true_sum += true_here.x + true_here.y + true_here.z;
        squares += dot(error, error);
    });
    const Color mean = 1 / count * sum;
    at_objects([&](int x, int y, Color error, bool has_neighbour) {
        if (!has_neighbour) return;
        const Color here = error - mean, next = image(x + 1, y) - truth(x + 1, y) - mean;
        products += dot(here, next);
        pair_squares += (dot(here, here) + dot(next, next)) / 2;
    });
    return {std::sqrt(squares / (3 * count)), pair_squares > 0 ? products / pair_squares : 0,
            (sum.x + sum.y + sum.z) / true_sum};
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
