#include "prediction.h"

#include "numerics/formatted.h"
#include "scene/sun.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

namespace bmc {
namespace {

// sun: the share of the light that both pictures may miss.
void tell_prediction(const PictureSettings& settings, double rmse, double sun) {
    std::string remark;
    if (sun > 0)
        remark = formatted("; it may miss the sun, %.3g %% of the light: take --known light", 100 * sun);
    else if (settings.method == Method::single)
        remark = "; all pixels share one rule, and this seed may be far off";
    std::fprintf(stderr, "renderer: %zu sample%s for a predicted RMSE of %.2g%s\n", settings.samples,
                 settings.samples == 1 ? "" : "s", rmse, remark.c_str());
}

// The root mean square of each pixel's colours, from black at 0 to white at `white`.
Image grey_scale(const Image& errors, double white) {
    return image_of(errors.width(), errors.height(), [&](int x, int y) {
        const double error = std::sqrt(dot(errors(x, y), errors(x, y)) / 3);
        const double level = white > 0 ? error / white : 0;
        return Color{level, level, level};
    });
}

}  // namespace

PictureSettings second(PictureSettings settings) {
    ++settings.seed;
    return settings;
}

Image standard_errors(const Scene& scene, const Image& a, const Image& b) {
    const Camera camera{a.width(), a.height()};
    const int reach = std::clamp(a.height() / 70, 3, 7);
    std::vector<std::optional<Object>> objects(a.size());
    const auto object = [&](int x, int y) -> auto& { return objects[static_cast<std::size_t>(y * a.width() + x)]; };
    for_each_hit(scene, camera, [&](int x, int y, const Hit& hit) { object(x, y) = hit.object; });
    return image_of(a.width(), a.height(), [&](int x, int y) {
        if (!object(x, y)) return Color{};
        double count = 0;
        Color squares;
        for (int j = std::max(0, y - reach); j <= std::min(a.height() - 1, y + reach); ++j)
            for (int i = std::max(0, x - reach); i <= std::min(a.width() - 1, x + reach); ++i) {
                if (object(i, j) != object(x, y)) continue;
                const Color difference = a(i, j) - b(i, j);
                squares += difference * difference;
                count += 1;
            }
        const Color variance = 0.5 / count * squares;
        return Color{std::sqrt(variance.x), std::sqrt(variance.y), std::sqrt(variance.z)};
    });
}

double root_mean_square(const Scene& scene, const Image& errors) {
    double squares = 0, count = 0;
    for_each_hit(scene, {errors.width(), errors.height()}, [&](int x, int y, const Hit&) {
        squares += dot(errors(x, y), errors(x, y));
        count += 3;
    });
    return count > 0 ? std::sqrt(squares / count) : 0;
}

double pilot_rmse(const Scene& scene, const EnvironmentLight& light, PictureSettings settings) {
    const Camera camera{settings.width, settings.height};
    const int across = std::max(1, settings.width / 64), down = std::max(1, settings.height / 64);
    double squares = 0, count = 0;
    for (int pair = 0; pair < 16 && count < 1000; ++pair) {
        const Shade a = shade_of(scene, light, settings), b = shade_of(scene, light, second(settings));
        for (int y = down / 2; y < settings.height; y += down)
            for (int x = across / 2; x < settings.width; x += across)
                if (const std::optional<Hit> hit = intersect(scene, camera.ray(x, y))) {
                    const Color difference = a(*hit, x, y) - b(*hit, x, y);
                    squares += dot(difference, difference);
                    count += 6;
                }
        settings.seed += 2;
    }
    return count > 0 ? std::sqrt(squares / count) : 0;
}

ChosenSamples samples_for(double target, std::size_t most, const Scene& scene, const EnvironmentLight& light,
                          PictureSettings settings) {
    if (settings.method != Method::mc) settings.method = Method::pool;
    settings.pool = std::min<std::size_t>(settings.pool, 4);
    const auto predict = [&](std::size_t samples) {
        settings.samples = samples;
        return pilot_rmse(scene, light, settings);
    };
    std::size_t lower = 0, samples = settings.shared ? 8 : 2;
    double rmse_of_lower = 0, rmse = predict(samples);
    while (rmse > target) {
        if (samples >= most)
            throw std::runtime_error(
                formatted("an RMSE of %g is out of reach: %zu samples, the most allowed, have one of %.2g", target,
                          samples, rmse));
        lower = samples;
        rmse_of_lower = rmse;
        samples = std::min(2 * samples, most);
        rmse = predict(samples);
    }
    if (lower == 0) return {samples, rmse};
    const double first = static_cast<double>(lower);
    const double slope = portable::log(rmse / rmse_of_lower) / portable::log(static_cast<double>(samples) / first);
    const double wanted = first * portable::pow(target / rmse_of_lower, 1 / slope);
    const std::size_t chosen = std::clamp(static_cast<std::size_t>(std::ceil(wanted)), lower + 1, samples);
    return {chosen, rmse_of_lower * portable::pow(static_cast<double>(chosen) / first, slope)};
}

Image asked_picture(const EnvironmentMap& environment, PictureSettings settings, const Prediction& prediction,
                    Format format) {
    const Scene scene = sphere_scene();
    const EnvironmentLight light =
        settings.known == Known::light ? prefilter(environment, settings.threads) : EnvironmentLight{environment};
    const double sun = light.prefiltered ? 0 : Sun(environment).share();
    if (prediction.rmse > 0) {
        if (sun > 0)
            throw UsageError(
                formatted("--rmse: the sun sends %.3g %% of the light, and samples that miss it do not "
                          "know of it; take --known light",
                          100 * sun));
        const ChosenSamples chosen = samples_for(prediction.rmse, max_process_samples, scene, light, settings);
        settings.samples = chosen.samples;
        tell_prediction(settings, chosen.rmse, 0);
    }
    const Image image = picture(scene, light, settings);
    if (prediction.show == Show::picture) return image;
    const Image errors = standard_errors(scene, image, picture(scene, light, second(settings)));
    const double rmse = root_mean_square(scene, errors);
    if (prediction.rmse == 0) tell_prediction(settings, rmse, sun);
    return format == Format::ppm ? grey_scale(errors, 2 * rmse) : errors;
}
}  // namespace bmc
