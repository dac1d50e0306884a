#include "beyond/prediction/prediction.h"

#include "numerics/formatted.h"

#include <algorithm>

namespace bmc::beyond {
PictureSettings with_next_seed(PictureSettings settings) {
    ++settings.seed;
    return settings;
}

Image standard_errors(const Image& a, const Image& b) {
    const int reach = std::clamp(a.height / 70, 3, 7);
    Image errors(a.width, a.height);
    std::vector<std::optional<Object>> objects(a.pixels.size());
    const auto object = [&](int x, int y) -> auto& { return objects[static_cast<std::size_t>(y * a.width + x)]; };
    for_each_hit(sphere_scene(), {a.width, a.height}, [&](int x, int y, const Hit& hit) { object(x, y) = hit.object; });
    for_each_hit(sphere_scene(), {a.width, a.height}, [&](int x, int y, const Hit& hit) {
        double count = 0;
        Color squares;
        for (int j = std::max(0, y - reach); j <= std::min(a.height - 1, y + reach); ++j)
            for (int i = std::max(0, x - reach); i <= std::min(a.width - 1, x + reach); ++i) {
                if (object(i, j) != hit.object) continue;
                const Color difference = a(i, j) - b(i, j);
                squares += difference * difference;
                count += 1;
            }
        const Color variance = 0.5 / count * squares;
        errors(x, y) = {std::sqrt(variance.x), std::sqrt(variance.y), std::sqrt(variance.z)};
    });
    return errors;
}

double root_mean_square(const Image& errors) {
    double squares = 0, count = 0;
    for_each_hit(sphere_scene(), {errors.width, errors.height}, [&](int x, int y, const Hit&) {
        squares += dot(errors(x, y), errors(x, y));
        count += 3;
    });
    return count > 0 ? std::sqrt(squares / count) : 0;
}

double pilot_rmse(const EnvironmentLight& light, PictureSettings settings) {
    const Scene scene = sphere_scene();
    const Camera camera{settings.width, settings.height};
    const int across = std::max(1, settings.width / 64), down = std::max(1, settings.height / 64);
    double squares = 0, count = 0;
    for (int pair = 0; pair < 16 && count < 1000; ++pair) {
        const PictureSettings next = with_next_seed(settings);
        const Shader a = shader_of(scene, light, settings, rules_of(light, settings));
        const Shader b = shader_of(scene, light, next, rules_of(light, next));
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

ChosenSamples samples_for(double target, std::size_t most, const EnvironmentLight& light, PictureSettings settings) {
    settings.pool = settings.method == Method::pool ? std::min<std::size_t>(settings.pool, 4) : 4;
    if (settings.method != Method::mc) settings.method = Method::pool;
    const auto predict = [&](std::size_t samples) {
        settings.samples = samples;
        return ChosenSamples{samples, pilot_rmse(light, settings)};
    };
    ChosenSamples last = predict(2);
    if (last.rmse <= target) return last;
    ChosenSamples next = predict(4);
    while (next.rmse > target && next.samples < most) {
        last = next;
        next = predict(std::min(2 * next.samples, most));
    }
    const double first = static_cast<double>(last.samples);
    const double slope =
        portable::log(next.rmse / last.rmse) / portable::log(static_cast<double>(next.samples) / first);
    const double wanted = first * portable::pow(target / last.rmse, 1 / slope);
    if (next.rmse > target)
        throw std::runtime_error(
            formatted("an RMSE of %g is out of reach: %zu samples, the most tried, have one of "
                      "%.2g, and about %.2g samples would be needed",
                      target, most, next.rmse, wanted));
    const std::size_t chosen = std::clamp(static_cast<std::size_t>(std::ceil(wanted)), last.samples + 1, next.samples);
    return {chosen, last.rmse * portable::pow(static_cast<double>(chosen) / first, slope)};
}
}  // namespace bmc::beyond
