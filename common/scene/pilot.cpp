#include "scene/pilot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace {

std::runtime_error unreachable(double target, std::size_t samples, double rmse) {
    char text[160];
    std::snprintf(text, sizeof text, "an RMSE of %g is out of reach: %zu samples, the most allowed, have one of %.2g",
                  target, samples, rmse);
    return std::runtime_error(text);
}

}  // namespace

Pilot run_pilot(const Scene& scene, const Light& light, const RenderSettings& settings, const PixelRules& rules) {
    const Camera camera{settings.width, settings.height};
    const int across = std::max(1, settings.width / 32), down = std::max(1, settings.height / 32);
    std::vector<PixelError> errors;
    Pilot pilot{{}, 0};
    for (int y = down / 2; y < settings.height; y += down)
        for (int x = across / 2; x < settings.width; x += across) {
            const std::optional<Hit> hit = intersect(scene, camera.ray(x, y));
            if (!hit) continue;
            Random random = pixel_stream(settings, x, y);
            errors.push_back(pixel_error(scene, light, settings.known, *hit, rules.of(hit->normal, random)));
            pilot.amplitude += errors.back().amplitude;
        }
    if (errors.empty()) return pilot;
    const double count = static_cast<double>(errors.size());
    pilot.amplitude = 1 / count * pilot.amplitude;
    double squares = 0;
    for (const PixelError& error : errors) {
        const Color predicted = standard_error(error, pilot.amplitude, rules.samples());
        squares += dot(predicted, predicted);
    }
    pilot.rmse = std::sqrt(squares / (3 * count));
    return pilot;
}

ChosenSamples samples_for(double target, std::size_t most, const Scene& scene, const Light& light,
                          RenderSettings settings) {
    const PrefilteredEnvironment* const averages = settings.known == KnownPart::light ? &light.averages() : nullptr;
    settings.show = Show::error;
    // A pool, and one of eight, as it changes nothing that is expected of a pixel's error.
    if (settings.method == Method::direct) settings.method = Method::pool;
    settings.pool = std::min<std::size_t>(settings.pool, 8);
    const auto predicted = [&](std::size_t samples) {
        settings.samples = samples;
        PixelRules rules(settings, averages);
        for (std::size_t i = rules.shared_count(); i > 0; --i) rules.make_shared_rule();
        return run_pilot(scene, light, settings, rules).rmse;
    };
    std::size_t few = 1, samples = averages && !averages->sun().empty() ? 4 : 2;
    double before = 0, rmse = predicted(samples);
    while (rmse > target) {
        if (samples >= most) throw unreachable(target, samples, rmse);
        few = samples;
        before = rmse;
        samples = std::min(2 * samples, most);
        rmse = predicted(samples);
    }
    if (few == 1) return {samples, rmse};
    const double first = static_cast<double>(few);
    const double power = portable::log(rmse / before) / portable::log(static_cast<double>(samples) / first);
    const double exact = first * portable::pow(target / before, 1 / power);
    const std::size_t chosen = std::clamp(static_cast<std::size_t>(std::ceil(exact)), few + 1, samples);
    return {chosen, before * portable::pow(static_cast<double>(chosen) / first, power)};
}
