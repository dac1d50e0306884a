// The pictures of the programs, with and without a known light: the one place that knows both kinds.
#pragma once

#include "known_light/prefiltered_environment.h"
#include "options.h"

#include <memory>

namespace bmc {
// What is known of the integrand L(w) V(w) cos(theta): nothing, the cosine, or the light and the cosine.
enum class Known { nothing, cosine, light };
constexpr std::pair<const char*, Known> known_names[] = {
    {"nothing", Known::nothing}, {"cosine", Known::cosine}, {"light", Known::light}};

struct PictureSettings : RenderSettings {
    bool light_known = false;

    void set_known(Known part);
    Known known_part() const;
};

// Monte Carlo takes one of a process's options: that the light is known.
struct PictureOptions : RenderOptions {
    explicit PictureOptions(PictureSettings& settings);
};

// An environment, which must outlive it, and its averages where the light is to be known.
struct EnvironmentLight {
    const EnvironmentMap& environment;
    std::shared_ptr<const PrefilteredEnvironment> prefiltered = nullptr;
};

// The environment with its averages, which so many threads make.
EnvironmentLight prefilter(const EnvironmentMap& environment, unsigned threads = 1);

// The image of linear radiance. Throws what the Gaussian processes throw.
Image picture(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings,
              const Progress& progress = nullptr);
}  // namespace bmc
