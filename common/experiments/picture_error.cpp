#include "experiments/picture_error.h"

#include <cmath>

ImageError image_error(const Scene& scene, const std::vector<Image>& images, const Image& truth) {
    const Camera camera{truth.width(), truth.height()};
    const auto shows_object = [&](int x, int y) { return intersect(scene, camera.ray(x, y)).has_value(); };
    double count = 0, sum = 0, true_sum = 0, squares = 0, products = 0, pair_squares = 0;
    for (int y = 0; y < truth.height(); ++y)
        for (int x = 0; x < truth.width(); ++x) {
            if (!shows_object(x, y)) continue;
            const bool has_neighbour = x + 1 < truth.width() && shows_object(x + 1, y);
            for (const Image& image : images) {
                const Color here = image(x, y), error = here - truth(x, y);
                const double squared = dot(error, error);
                count += 3;
                sum += here.x + here.y + here.z;
                true_sum += truth(x, y).x + truth(x, y).y + truth(x, y).z;
                squares += squared;
                if (!has_neighbour) continue;
                const Color next = image(x + 1, y) - truth(x + 1, y);
                products += dot(error, next);
                pair_squares += (squared + dot(next, next)) / 2;
            }
        }
    return {std::sqrt(squares / count), products / pair_squares, sum / true_sum - 1};
}
