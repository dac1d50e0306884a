#include "judge/background.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "judge/picture_file.h"

namespace {

// What a channel lacks, in codes.
double missing_codes(double here, double right, double largest, int maxval) {
    return maxval > 0 ? maxval * (srgb_encoded(right) - srgb_encoded(here)) : 128 * (right - here) / largest;
}

Background compared(const Image& picture, int maxval, const Image& expected, const std::vector<bool>& mask) {
    double count = 0, differing = 0, channels = 0, lacking = 0;
    std::size_t pixel = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x, ++pixel) {
            if (mask[pixel]) continue;
            const Color here = picture(x, y), right = expected(x, y);
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
    return {count > 0 ? differing / count : 0, channels > 100 && maxval > 0 ? lacking / channels : 0};
}

Image with_texels(const EnvironmentMap& environment, Image truth, const std::vector<bool>& mask) {
    const Camera camera{truth.width(), truth.height()};
    std::size_t pixel = 0;
    for (int y = 0; y < truth.height(); ++y)
        for (int x = 0; x < truth.width(); ++x, ++pixel)
            if (!mask[pixel]) truth.set(x, y, environment.radiance(camera.ray(x, y).direction));
    return truth;
}

}  // namespace

Background background_of(const Image& picture, int maxval, const Image& truth, const std::vector<bool>& mask,
                         const EnvironmentMap& environment) {
    const Background interpolated = compared(picture, maxval, truth, mask),
                     texels = compared(picture, maxval, with_texels(environment, truth, mask), mask);
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
