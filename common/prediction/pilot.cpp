#include "prediction/pilot.h"

#include "numerics/formatted.h"

#include <algorithm>
#include <stdexcept>

namespace bmc {
Pilot run_pilot(const Scene& scene, const RenderSettings& settings, const ErrorOf& error_of) {
    const Camera camera{settings.width, settings.height};
    const int across = std::max(1, settings.width / 32), down = std::max(1, settings.height / 32);
    std::vector<PixelError> errors;
    Pilot pilot{{}, 0};
    for (int y = down / 2; y < settings.height; y += down)
        for (int x = across / 2; x < settings.width; x += across) {
            const std::optional<Hit> hit = intersect(scene, camera.ray(x, y));
            if (!hit) continue;
            Random random = pixel_stream(settings, x, y);
            errors.push_back(error_of(*hit, random));
            pilot.squared_amplitude += errors.back().squared_amplitude;
        }
    if (errors.empty()) return pilot;
    const double count = static_cast<double>(errors.size());
    pilot.squared_amplitude = 1 / count * pilot.squared_amplitude;
    double squares = 0;
    for (const PixelError& error : errors) {
        const Color predicted = standard_error(error, pilot.squared_amplitude);
        squares += dot(predicted, predicted);
    }
    pilot.rmse = std::sqrt(squares / (3 * count));
    return pilot;
}

Image predicted_errors(const Scene& scene, const RenderSettings& settings, const ErrorOf& error_of,
                       const Progress& progress) {
    const EnvironmentMap black(1, 1, {0, 0, 0});
    const Color amplitude = run_pilot(scene, settings, error_of).squared_amplitude;
    const auto shade = [&](const Hit& hit, Random& random) { return standard_error(error_of(hit, random), amplitude); };
    return render(scene, black, settings, shade, progress);
}

ChosenSamples samples_for(double target, std::size_t least, std::size_t most, const Scene& scene,
                          RenderSettings settings, const std::function<ErrorOf(const RenderSettings&)>& error_of) {
    if (settings.method == Method::direct) settings.method = Method::pool;
    settings.pool = std::min<std::size_t>(settings.pool, 8);
    const auto predict = [&](std::size_t samples) {
        settings.samples = samples;
        return run_pilot(scene, settings, error_of(settings)).rmse;
    };
    std::size_t lower = 0, samples = least;
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
}  // namespace bmc
