#include "judge/likely_mistakes.h"

#include <algorithm>

#include "experiments/picture_error.h"
#include "judge/picture_file.h"
#include "quadrature/hemisphere.h"

using portable::pi;

namespace {

struct Suspect {
    std::string name;
    Image image;
};

// Every pixel is that of f(x, y).
template <class Pixel>
Image image_of(int width, int height, Pixel pixel) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) image.set(x, y, pixel(x, y));
    return image;
}

template <class Function>
Color each(Color color, Function f) {
    return {f(color.x), f(color.y), f(color.z)};
}

// What a point would reflect with other mistakes than a wrong factor.
struct WrongShades {
    Color cosine_twice, no_cosine, no_shadow;
};

WrongShades wrong_shades(const Scene& scene, const EnvironmentMap& environment, const Hit& hit,
                         const std::vector<Vec3>& directions) {
    const Frame frame(hit.normal);
    WrongShades sums;
    for (const Vec3& local : directions) {
        const Vec3 direction = frame.to_world(local);
        const Color light = environment.radiance(direction);
        sums.no_shadow = sums.no_shadow + local.y * light;
        if (is_shadowed(scene, hit, direction)) continue;
        sums.cosine_twice = sums.cosine_twice + local.y * local.y * light;
        sums.no_cosine = sums.no_cosine + light;
    }
    const double weight = 2 / static_cast<double>(directions.size());  // 2 pi / n, times 1 / pi
    for (Color* sum : {&sums.cosine_twice, &sums.no_cosine, &sums.no_shadow})
        *sum = {weight * hit.albedo.x * sum->x, weight * hit.albedo.y * sum->y, weight * hit.albedo.z * sum->z};
    return sums;
}

// Mistakes in the integrand.
void add_wrong_integrands(std::vector<Suspect>& suspects, const Scene& scene, const EnvironmentMap& environment,
                          const Image& picture, const Image& truth, int step) {
    const Camera camera{picture.width(), picture.height()};
    const std::vector<Vec3> directions = fibonacci_directions(500);
    Image twice = truth, none = truth, lit = truth, white = truth;
    for (int y = 0; y < truth.height(); ++y)
        for (int x = 0; x < truth.width(); ++x) {
            const auto hit = intersect(scene, camera.ray(step * x + step / 2, step * y + step / 2));
            if (!hit) continue;
            const WrongShades shades = wrong_shades(scene, environment, *hit, directions);
            const Color right = truth(x, y);
            twice.set(x, y, shades.cosine_twice);
            none.set(x, y, shades.no_cosine);
            lit.set(x, y, shades.no_shadow);
            white.set(x, y, {right.x / hit->albedo.x, right.y / hit->albedo.y, right.z / hit->albedo.z});
        }
    suspects.push_back({"cos(theta) twice", std::move(twice)});
    suspects.push_back({"cos(theta) is missing", std::move(none)});
    suspects.push_back({"no shadows", std::move(lit)});
    suspects.push_back({"the albedo is missing", std::move(white)});
}

// Mistakes in a factor: what shows an object is so many times as bright.
void add_wrong_factors(std::vector<Suspect>& suspects, const Image& truth, const std::vector<bool>& mask,
                       std::size_t samples) {
    const double n = static_cast<double>(samples);
    const std::pair<const char*, double> factors[] = {{"1 / pi is missing", pi},
                                                      {"divided by pi twice", 1 / pi},
                                                      {"half as bright: weights pi / N in place of 2 pi / N", 0.5},
                                                      {"twice as bright", 2},
                                                      {"a quarter as bright", 0.25},
                                                      {"2 pi is missing: z, or weights 1 / N", 1 / (2 * pi)},
                                                      {"2 pi too often", 2 * pi},
                                                      {"divided by N twice", 1 / n},
                                                      {"not divided by N, or w = z", n},
                                                      {"the objects are black", 0}};
    for (const auto& [name, factor] : factors)
        suspects.push_back({name, image_of(truth.width(), truth.height(), [&, f = factor](int x, int y) {
                                const bool object = mask[static_cast<std::size_t>(y * truth.width() + x)];
                                return object ? f * truth(x, y) : truth(x, y);
                            })});
}

// Mistakes in where pixels are and in the codes that they are written with, on the whole picture.
void add_wrong_pictures(std::vector<Suspect>& suspects, const Image& truth, const std::vector<bool>& mask, int maxval) {
    const int width = truth.width(), height = truth.height();
    const auto add = [&](const char* name, auto pixel) { suspects.push_back({name, image_of(width, height, pixel)}); };
    add("upside down", [&](int x, int y) { return truth(x, height - 1 - y); });
    add("mirrored, left and right exchanged", [&](int x, int y) { return truth(width - 1 - x, y); });
    add("turned by half a turn", [&](int x, int y) { return truth(width - 1 - x, height - 1 - y); });
    add("red and blue exchanged", [&](int x, int y) { return Color{truth(x, y).z, truth(x, y).y, truth(x, y).x}; });
    add("the background is black",
        [&](int x, int y) { return mask[static_cast<std::size_t>(y * width + x)] ? truth(x, y) : Color{}; });
    const auto encoded = [&](int x, int y) { return each(truth(x, y), srgb_encoded); };
    if (maxval == 0) {
        add("sRGB codes in a PFM, which holds linear values", encoded);
        return;
    }
    add("encoded by the sRGB curve twice", encoded);
    add("linear values in a PPM, which holds sRGB codes",
        [&](int x, int y) { return each(truth(x, y), [](double v) { return srgb_decoded(std::min(v, 1.0)); }); });
    add("encoded by a gamma of 2.2 in place of the sRGB curve", [&](int x, int y) {
        return each(truth(x, y), [](double v) { return srgb_decoded(portable::pow(std::min(v, 1.0), 1 / 2.2)); });
    });
}

// Over the pixels that show an object, or over the others.
double squared_difference(const Image& a, const Image& b, const std::vector<bool>& mask, bool objects) {
    double sum = 0;
    std::size_t pixel = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x, ++pixel) {
            if (mask[pixel] != objects) continue;
            const Color difference = a(x, y) - b(x, y);
            sum += dot(difference, difference);
        }
    return sum;
}

// The suspect that the picture differs least from there, if its squared difference is under a quarter of the truth's.
std::string best_match(const std::vector<Suspect>& suspects, const Image& truth, const Image& here, int maxval,
                       const std::vector<bool>& mask, bool objects) {
    std::string name;
    double least = squared_difference(here, stored(truth, maxval), mask, objects) / 4;
    for (const Suspect& suspect : suspects) {
        const double error = squared_difference(here, stored(suspect.image, maxval), mask, objects);
        if (error >= least) continue;
        least = error;
        name = suspect.name;
    }
    return name;
}

}  // namespace

Image thinned(const Image& image, int step) {
    const auto left = [&](int side) { return (side - step / 2 + step - 1) / step; };
    return image_of(left(image.width()), left(image.height()),
                    [&](int x, int y) { return image(step * x + step / 2, step * y + step / 2); });
}

std::vector<bool> thinned(const std::vector<bool>& mask, int width, int height, int step) {
    std::vector<bool> left;
    for (int y = step / 2; y < height; y += step)
        for (int x = step / 2; x < width; x += step) left.push_back(mask[static_cast<std::size_t>(y * width + x)]);
    return left;
}

std::string likely_mistake(const EnvironmentMap& environment, const Image& picture, int maxval, const Image& truth,
                           std::size_t samples, bool background_fits) {
    const Scene scene = sphere_scene();
    const int width = picture.width(), height = picture.height(), step = std::max(1, std::min(width, height) / 100);
    const Image here = thinned(picture, step), right = thinned(truth, step);
    const std::vector<bool> mask = thinned(object_mask(scene, width, height), width, height, step);
    std::vector<Suspect> whole, objects;
    add_wrong_pictures(whole, right, mask, maxval);
    const std::string name = best_match(whole, right, here, maxval, mask, false);
    if (!name.empty() || !background_fits) return name;
    add_wrong_integrands(objects, scene, environment, picture, right, step);
    add_wrong_factors(objects, right, mask, samples);
    return best_match(objects, right, here, maxval, mask, true);
}
