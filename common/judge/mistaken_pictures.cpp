#include "judge/mistaken_pictures.h"

#include <algorithm>
#include <cmath>

#include "judge/likely_mistakes.h"
#include "quadrature/hemisphere.h"
#include "scene/scene.h"

namespace {

struct Mistaken {
    std::string name;
    Image image;
};

// Every pixel is that of f(x, y).
template <class Pixel>
Image image_of(const Image& like, Pixel pixel) {
    Image image(like.width(), like.height());
    for (int y = 0; y < like.height(); ++y)
        for (int x = 0; x < like.width(); ++x) image.set(x, y, pixel(x, y));
    return image;
}

template <class Function>
Color each(Color color, Function f) {
    return {f(color.x), f(color.y), f(color.z)};
}

// Mistakes in where pixels are and in the codes that they are written with.
std::vector<Mistaken> wrong_pictures(const Truth& truth, bool codes) {
    const Image& right = truth.image;
    std::vector<Mistaken> all;
    const auto add = [&](const char* name, auto pixel) { all.push_back({name, image_of(right, pixel)}); };
    for (const Mirroring& mirroring : mirrorings)
        add(mirroring.name, [&](int x, int y) {
            return right(mirroring.left_right ? right.width() - 1 - x : x,
                         mirroring.up_down ? right.height() - 1 - y : y);
        });
    add("red and blue exchanged", [&](int x, int y) { return Color{right(x, y).z, right(x, y).y, right(x, y).x}; });
    add("the background is black", [&](int x, int y) { return truth.shows_object(x, y) ? right(x, y) : Color{}; });
    add(codes ? "encoded by the sRGB curve twice" : "sRGB codes in a PFM, which holds linear values",
        [&](int x, int y) { return each(right(x, y), srgb_encoded); });
    if (!codes) return all;
    add("linear values in a PPM, which holds sRGB codes",
        [&](int x, int y) { return each(right(x, y), [](double v) { return srgb_decoded(std::min(v, 1.0)); }); });
    add("encoded by a gamma of 2.2 in place of the sRGB curve", [&](int x, int y) {
        return each(right(x, y), [](double v) { return srgb_decoded(portable::pow(std::min(v, 1.0), 1 / 2.2)); });
    });
    return all;
}

// What a point would reflect with mistakes in the integrand.
struct WrongShades {
    Color cosine_twice, no_cosine, no_shadow;
};

WrongShades wrong_shades(const Hit& hit, const EnvironmentMap& environment, const std::vector<Vec3>& directions) {
    const Scene scene = sphere_scene();
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
    for (Color* sum : {&sums.cosine_twice, &sums.no_cosine, &sums.no_shadow}) *sum = weight * (hit.albedo * *sum);
    return sums;
}

std::vector<Mistaken> wrong_integrands(const Image& right, const EnvironmentMap& environment) {
    const Camera camera{right.width(), right.height()};
    const std::vector<Vec3> directions = fibonacci_directions(300);
    Image twice = right, none = right, lit = right, white = right;
    for (int y = 0; y < right.height(); ++y)
        for (int x = 0; x < right.width(); ++x) {
            const auto hit = intersect(sphere_scene(), camera.ray(x, y));
            if (!hit) continue;
            const WrongShades shades = wrong_shades(*hit, environment, directions);
            const Color color = right(x, y);
            twice.set(x, y, shades.cosine_twice);
            none.set(x, y, shades.no_cosine);
            lit.set(x, y, shades.no_shadow);
            white.set(x, y, {color.x / hit->albedo.x, color.y / hit->albedo.y, color.z / hit->albedo.z});
        }
    return {{"cos(theta) twice", twice},
            {"cos(theta) is missing", none},
            {"no shadows", lit},
            {"the albedo is missing", white}};
}

// The truth first, then with mistakes in a factor.
std::vector<Mistaken> wrong_factors(const Truth& truth, std::size_t samples) {
    const double n = static_cast<double>(samples);
    std::vector<Factor> known = {{"", 1}};
    known.insert(known.end(), std::begin(factors), std::end(factors));
    known.push_back({"not divided by N, or w = z", n});
    known.push_back({"divided by N twice", 1 / n});
    known.push_back({"the objects are black", 0});
    std::vector<Mistaken> all;
    for (const Factor& each : known)
        all.push_back({each.name, image_of(truth.image, [&](int x, int y) {
                           return (truth.shows_object(x, y) ? each.factor : 1) * truth.image(x, y);
                       })});
    return all;
}

// Over the pixels that show an object, or over the others: the root of the mean square.
double rms(const Image& a, const Image& b, const Truth& truth, bool objects) {
    double sum = 0, count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            if (truth.shows_object(x, y) != objects) continue;
            const Color difference = a(x, y) - b(x, y);
            sum += dot(difference, difference);
            count += 3;
        }
    return count > 0 ? std::sqrt(sum / count) : 0;
}

// The last of those that come closest to the objects of the picture, up to 2 %, if it comes as close as correct
// pictures do.
std::string closest(const std::vector<Mistaken>& all, const PictureFile& picture, const Truth& truth, double rmse) {
    const double light = rms(truth.image, Image(truth.image.width(), truth.image.height()), truth, true);
    std::string name;
    double least = HUGE_VAL;
    for (const Mistaken& each : all) {
        const Image image = stored(each.image, picture.maxval);
        const double error = rms(picture.image, image, truth, true);
        const double here = rms(image, Image(image.width(), image.height()), truth, true);
        if (error > 1.02 * least || error > rmse * here / light + 0.002) continue;
        least = std::min(least, error);
        name = each.name;
    }
    return name;
}

}  // namespace

std::string mistake_of_whole(const PictureFile& picture, const Truth& dense, double rmse) {
    const double wrong = rms(picture.image, stored(dense.image, picture.maxval), dense, false);
    std::vector<Mistaken> likely = {{"", dense.image}};
    for (Mistaken& each : wrong_pictures(dense, picture.maxval > 0))
        if (rms(picture.image, stored(each.image, picture.maxval), dense, false) < wrong / 4)
            likely.push_back(std::move(each));
    return closest(likely, picture, dense, 2 * rmse);
}

std::string mistake_of_objects(const PictureFile& picture, const Truth& dense, const EnvironmentMap& environment,
                               std::size_t samples, double rmse) {
    std::vector<Mistaken> all = wrong_factors(dense, samples);
    for (Mistaken& each : wrong_integrands(dense.image, environment)) all.push_back(std::move(each));
    return closest(all, picture, dense, rmse);
}
