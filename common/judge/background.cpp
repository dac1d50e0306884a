#include "judge/background.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "scene/scene.h"

namespace {

// What a channel lacks, in codes.
double missing_codes(double here, double right, double largest, int maxval) {
    return maxval > 0 ? maxval * (srgb_encoded(right) - srgb_encoded(here)) : 128 * (right - here) / largest;
}

Background compared(const PictureFile& picture, const Truth& expected) {
    const int maxval = picture.maxval;
    double count = 0, differing = 0, channels = 0, lacking = 0;
    for (int y = 0; y < picture.image.height(); ++y)
        for (int x = 0; x < picture.image.width(); ++x) {
            if (expected.shows_object(x, y)) continue;
            const Color here = picture.image(x, y), right = expected.image(x, y);
            const double largest = std::max({right.x, right.y, right.z, 1e-6});
            bool differs = false;
            for (const auto& [a, b] : {std::pair(here.x, right.x), {here.y, right.y}, {here.z, right.z}}) {
                const double missing = missing_codes(a, b, largest, maxval);
                differs = differs || !(std::fabs(missing) <= 1.5);
                if (std::fabs(missing) > 1.5 || b >= 1) continue;
                lacking += missing;
                channels += 1;
            }
            differing += differs;
            count += 1;
        }
    count = std::max(1.0, count);
    return {differing / count, std::max(0.001, 2 / count), channels > 100 && maxval > 0 ? lacking / channels : 0};
}

Truth with_texels(Truth truth, const EnvironmentMap& environment) {
    const Camera camera{truth.image.width(), truth.image.height()};
    for (int y = 0; y < truth.image.height(); ++y)
        for (int x = 0; x < truth.image.width(); ++x)
            if (!truth.shows_object(x, y)) truth.image.set(x, y, environment.radiance(camera.ray(x, y).direction));
    return truth;
}

}  // namespace

Background background_of(const PictureFile& picture, const Truth& truth, const EnvironmentMap& environment) {
    const Background interpolated = compared(picture, truth),
                     texels = compared(picture, with_texels(truth, environment));
    return texels.differing < interpolated.differing ? texels : interpolated;
}

Image unrounded(Image image, int maxval, double offset) {
    const auto value = [&](double linear) {
        const double code = maxval * srgb_encoded(linear);
        if (code < 0.5 || code > maxval - 0.5) return linear;
        return srgb_decoded(std::max(0.0, code + offset) / maxval);
    };
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const Color c = image(x, y);
            image.set(x, y, {value(c.x), value(c.y), value(c.z)});
        }
    return image;
}
