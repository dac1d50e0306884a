// The pictures of the renderer, with and without a known light: the one place that knows both kinds.
#pragma once

#include "known_light/prefiltered_environment.h"
#include "prediction/pilot.h"

namespace bmc {
// What a picture shows of each point: the light that it reflects, or the standard error that is predicted for that.
enum class Show { picture, error };
constexpr std::pair<const char*, Show> show_names[] = {{"picture", Show::picture}, {"error", Show::error}};

// What is known of the integrand L(w) V(w) cos(theta): nothing, the cosine, or the light and the cosine.
enum class Known { nothing, cosine, light };
constexpr std::pair<const char*, Known> known_names[] = {
    {"nothing", Known::nothing}, {"cosine", Known::cosine}, {"light", Known::light}};

struct PictureSettings : RenderSettings {
    bool light_known = false;
    Show show = Show::picture;
    double rmse = 0;  // that is asked for, predicted; 0: the number of samples is given

    void set_known(Known part);
    Known known_part() const;
    bool asks_for_error() const { return rmse > 0 || show == Show::error; }
};

// An environment, which must outlive it, and its averages where the light is to be known.
struct EnvironmentLight {
    const EnvironmentMap& environment;
    std::shared_ptr<const PrefilteredEnvironment> prefiltered = nullptr;
};

// The environment with its averages, which so many threads make.
EnvironmentLight prefilter(const EnvironmentMap& environment, unsigned threads = 1);

// The share of the light that comes from a sun (sun.h), where the light is not known: samples meet it by chance.
double unknown_sun(const EnvironmentMap& environment, const PictureSettings& settings);

// The image of linear radiance, or of its predicted standard errors. Throws what the Gaussian processes throw, and
// std::invalid_argument for errors of one sample that knows nothing of its own.
Image picture(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings,
              const Progress& progress = nullptr);

// The fewest samples, but at least 2 (4 beside a known sun), with which the predicted RMSE is at most the target.
// most: at least 4. Throws std::runtime_error if so many do not suffice.
ChosenSamples samples_for(double target, std::size_t most, const Scene& scene, const EnvironmentLight& light,
                          const PictureSettings& settings);
}  // namespace bmc
