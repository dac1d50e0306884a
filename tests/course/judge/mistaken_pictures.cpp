#include "mistaken_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "likely_mistakes.h"
#include "quadrature/hemisphere.h"
#include "scene/scene.h"

namespace {

struct Mistaken {
    std::string name;
    Image image;
};

// Mistakes in where pixels are and in the codes that they are written with.
std::vector<Mistaken> wrong_pictures(const Truth& truth, bool codes) {
    const Image& right = truth.image;
    const int width = right.width(), height = right.height();
    std::vector<Mistaken> all;
    const auto add = [&](const char* name, auto pixel) { all.push_back({name, image_of(width, height, pixel)}); };
    for (const Mirroring& mirroring : mirrorings)
        add(mirroring.name, [&](int x, int y) {
            return right(mirroring.left_right ? width - 1 - x : x, mirroring.up_down ? height - 1 - y : y);
        });
    add("red and blue exchanged", [&](int x, int y) { return Color{right(x, y).z, right(x, y).y, right(x, y).x}; });
    add("the background is black", [&](int x, int y) { return truth.shows_object(x, y) ? right(x, y) : Color{}; });
    all.push_back({codes ? "encoded by the sRGB curve twice" : "sRGB codes in a PFM, which holds linear values",
                   each_channel(right, srgb_encoded)});
    if (!codes) return all;
    all.push_back({"linear values in a PPM, which holds sRGB codes",
                   each_channel(right, [](double v) { return srgb_decoded(std::min(v, 1.0)); })});
    all.push_back({"encoded by a gamma of 2.2 in place of the sRGB curve", each_channel(right, [](double v) {
                       return srgb_decoded(portable::pow(std::min(v, 1.0), 1 / 2.2));
                   })});
    return all;
}

// What a point would reflect with cos(theta) twice, without cos(theta), without shadows.
std::array<Color, 3> wrong_shades(const Hit& hit, const EnvironmentMap& environment,
                                  const std::vector<Vec3>& directions) {
    const Frame frame(hit.normal);
    const double weight = 2 / static_cast<double>(directions.size());  // 2 pi / n, times 1 / pi
    std::array<Color, 3> shades;
    for (const Vec3& local : directions) {
        const Vec3 direction = frame.to_world(local);
        const Color light = weight * (hit.albedo * environment.radiance(direction));
        const double visible = is_shadowed(sphere_scene(), hit, direction) ? 0 : 1;
        shades[0] += visible * local.y * local.y * light;
        shades[1] += visible * light;
        shades[2] += local.y * light;
    }
    return shades;
}

std::vector<Mistaken> wrong_integrands(const Image& right, const EnvironmentMap& environment) {
    const Camera camera{right.width(), right.height()};
    const std::vector<Vec3> directions = fibonacci_directions(300);
    std::vector<Mistaken> all{{"cos(theta) twice", right},
                              {"cos(theta) is missing", right},
                              {"no shadows", right},
                              {"the albedo is missing", right}};
    for (int y = 0; y < right.height(); ++y)
        for (int x = 0; x < right.width(); ++x) {
            const auto hit = intersect(sphere_scene(), camera.ray(x, y));
            if (!hit) continue;
            const std::array<Color, 3> shades = wrong_shades(*hit, environment, directions);
            for (std::size_t i = 0; i < 3; ++i) all[i].image.set(x, y, shades[i]);
            const Color color = right(x, y), albedo = hit->albedo;
            all[3].image.set(x, y, {color.x / albedo.x, color.y / albedo.y, color.z / albedo.z});
        }
    return all;
}

// The truth first, then with mistakes in a factor.
std::vector<Mistaken> wrong_factors(const Truth& truth, std::size_t samples) {
    const double n = static_cast<double>(samples);
    std::vector<Factor> known{{"", 1},
                              {"not divided by N, w = z, or w = Q z", n},  // in codes all are white
                              {"divided by N twice", 1 / n},
                              {"the objects are black", 0}};
    known.insert(known.begin() + 1, std::begin(factors), std::end(factors));
    std::vector<Mistaken> all;
    for (const Factor& each : known)
        all.push_back({each.name, image_of(truth.image.width(), truth.image.height(), [&](int x, int y) {
                           return (truth.shows_object(x, y) ? each.factor : 1) * truth.image(x, y);
                       })});
    return all;
}

// Over the pixels that show an object, or over the others: the root of the mean square.
double rms(const Image& a, const Image& b, const Truth& truth, bool objects) {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (truth.mask[i] != objects) continue;
        sum += squared_distance(a[i], b[i]);
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
