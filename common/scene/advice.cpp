#include "scene/advice.h"

#include "base/formatted.h"
#include "base/statistics.h"
#include "base/terminal.h"
#include "scene/scene.h"

namespace bmc {
// The standard deviation of the light over its mean, where a direction counts by cos(theta) on the rectangle, whose
// normal is +y, and on the side of the sphere that the camera sees, whose mean normal is +z. Of a texel, the solid
// angle is in proportion to the sine of the polar angle.
static double contrast(const EnvironmentMap& light) {
    const TexelsOnSphere texels(light);
    std::vector<double> towards_camera;
    for (int column = 0; column < texels.columns; ++column)
        towards_camera.push_back(-texels.azimuth(column + 0.5).cosine);
    Vec3 sums;  // of the weights, and of R + G + B and its square with these weights
    for (int row = 0; row < texels.rows; ++row) {
        const auto [sine, cosine] = texels.polar(row + 0.5);
        for (int column = 0; column < texels.columns; ++column) {
            const double seen = std::max(0.0, cosine) + std::max(0.0, sine * towards_camera[std::size_t(column)]);
            const double b = channel_sum(texels(row, column));
            sums += sine * seen * Vec3{1, b, b * b};
        }
    }
    return std::sqrt(std::max(0.0, sums.x * sums.z / (sums.y * sums.y) - 1));
}

void note_uneven_light(const EnvironmentMap& light, std::size_t samples) {
    const double c = contrast(light), lamp = 1 / (1 + c * c), n = static_cast<double>(samples);
    if (!(c > std::sqrt(n) / 2)) return;
    print_note(
        formatted("note: on these objects the light is as uneven as one lamp's in %.2g %% of all directions, where "
                  "%.2g of %zu random samples look; its standard deviation is %.3g times its mean",
                  100 * lamp, n * lamp, samples, c));
    print_note("note: --known light models this light");
}

// On average over the shared rules, or over four fresh ones where pixels share none.
void warn_of_weights(const PixelRules& rules) {
    SharedRules examined = rules.shared;
    for (int x = 0; x < 4 && rules.shared.empty(); ++x) {
        Random random = pixel_stream(rules.settings, x, 0);
        examined.push_back(rules.fresh_rule(random));
    }
    RootMeanSquare gain;
    Statistics white;
    for (const auto& rule : examined) {
        gain.add(noise_gain(*rule));
        white.add(white_brightness(*rule));
    }
    const double excess = white.mean - 1;
    const double monte_carlo_error = 1 / std::sqrt(3 * static_cast<double>(rules.settings.samples));
    std::string harm;
    if (gain.value() > 2)
        harm = "the weights amplify errors of samples " + two_digits(gain.value()) + " times as much as Monte Carlo's";
    else if (std::fabs(excess) > 2 * monte_carlo_error)
        harm = formatted("the weights make a white world %.0f %% too %s, more than twice Monte Carlo's error",
                         100 * std::fabs(excess), excess < 0 ? "dark" : "bright");
    if (!harm.empty()) print_note("warning: " + harm + "; take the default method, covariance and noise");
}

void warn_of_exposure(const Image& image, double exposure) {
    const auto brightest_channel = [](Colour pixel) { return std::max({pixel.x, pixel.y, pixel.z}); };
    const auto above_white = [&](Colour pixel) { return brightest_channel(pixel) > 1; };
    if (std::none_of(image.pixels.begin(), image.pixels.end(), above_white)) return;
    std::vector<double> brightest;
    for_each_hit({image.width, image.height},
                 [&](int x, int y, const Hit&) { brightest.push_back(brightest_channel(image(x, y))); });
    std::sort(brightest.begin(), brightest.end());
    const std::size_t n = brightest.size();
    if (n == 0 || brightest[n - 1 - n / 10] <= 1) return;
    print_note(
        formatted("warning: more than a tenth of the objects' pixels is brighter than white; --exposure %.1f makes the "
                  "brightest hundredth white",
                  exposure - portable::log(brightest[n - 1 - n / 100]) / portable::log(2)));
}
}  // namespace bmc
