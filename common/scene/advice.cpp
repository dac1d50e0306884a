#include "scene/advice.h"

#include "base/formatted.h"
#include "base/statistics.h"
#include "light/averages.h"

namespace bmc {
bool note_missed_light(const EnvironmentMap& light, std::size_t samples) {
    const double c = contrast(light), error = 1.4 * c / std::sqrt(static_cast<double>(samples));
    if (!(error > 0.5)) return false;
    print_note("note: in random directions, expect an error of about " + two_digits(100 * error) +
               " % of the picture's brightness " +
               formatted("with %zu samples: the standard deviation of the light is %.2g times its mean", samples, c));
    return true;
}

// On average over the shared rules, or over four fresh ones where pixels share none.
static void warn_of_weights(const PixelRules& rules) {
    SharedRules examined = rules.shared;
    for (int x = 0; x < 4 && rules.shared.empty(); ++x) {
        Random random = pixel_stream(rules.settings, x, 0);
        examined.push_back(rules.fresh_rule(random));
    }
    RootMeanSquare gain;
    Statistics brightness;
    for (const auto& rule : examined) {
        gain.add(noise_gain(*rule));
        brightness.add(white_brightness(*rule));
    }
    const double excess = brightness.mean - 1;
    const double monte_carlo_error = 1 / std::sqrt(3 * static_cast<double>(rules.settings.samples));
    std::string harm;
    if (gain.value() > 2)
        harm = "the weights amplify errors of samples " + two_digits(gain.value()) + " times as much as Monte Carlo's";
    else if (std::fabs(excess) > 2 * monte_carlo_error)
        harm = formatted("the weights make a white world %.0f %% too %s, more than twice Monte Carlo's error",
                         100 * std::fabs(excess), excess < 0 ? "dark" : "bright");
    if (!harm.empty()) print_note("warning: " + harm + "; take the default method, covariance and noise");
}

Shader warned_shader(const EnvironmentMap& light, const RenderSettings& settings) {
    const PixelRules rules(settings);
    warn_of_weights(rules);
    return environment_shader(light, rules);
}

void warn_of_exposure(const Image& image, double exposure) {
    const auto brightest_channel = [](Colour pixel) { return std::max({pixel.x, pixel.y, pixel.z}); };
    const auto above_white = [&](Colour pixel) { return brightest_channel(pixel) > 1; };
    if (std::none_of(image.pixels.begin(), image.pixels.end(), above_white)) return;
    std::vector<double> brightness;
    for_each_hit(sphere_scene, {image.width, image.height},
                 [&](int x, int y, const Hit&) { brightness.push_back(brightest_channel(image(x, y))); });
    std::sort(brightness.begin(), brightness.end());
    const std::size_t n = brightness.size();
    if (n == 0 || brightness[n - 1 - n / 10] <= 1) return;
    print_note(
        formatted("warning: more than a tenth of the objects' pixels is brighter than white; --exposure %.1f makes the "
                  "brightest hundredth white",
                  exposure - portable::log(brightness[n - 1 - n / 100]) / portable::log(2)));
}
}  // namespace bmc
