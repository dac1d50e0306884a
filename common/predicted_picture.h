// The predicted errors of pictures (picture.h), the options that ask for them, and the picture that is asked for.
#pragma once

#include "picture.h"
#include "prediction/pilot.h"

namespace bmc {
// What a picture shows of each point: the light that it reflects, or the standard error that is predicted for that.
enum class Show { picture, error };
constexpr std::pair<const char*, Show> show_names[] = {{"picture", Show::picture}, {"error", Show::error}};

// What is asked of a picture's error.
struct Prediction {
    Show show = Show::picture;
    double rmse = 0;  // the predicted one to reach; 0: the number of samples is given

    bool is_asked() const { return rmse > 0 || show == Show::error; }
};

struct PredictionOptions {
    Option rmse, show;

    explicit PredictionOptions(Prediction& prediction);
};

// Throws UsageError where errors are asked for and the settings' samples say nothing of them.
void require_predictable(const Prediction& prediction, const PictureSettings& settings);

// The predicted standard errors of a picture. Throws what the Gaussian processes throw, and std::invalid_argument for
// one sample that says nothing of its own error.
Image predicted_picture(const Scene& scene, const EnvironmentLight& light, const PictureSettings& settings,
                        const Progress& progress = nullptr);

// The fewest samples, but at least 2 (4 beside a known sun), with which the predicted RMSE is at most the target.
// most: at least 4. Throws std::runtime_error if so many do not suffice.
ChosenSamples samples_for(double target, std::size_t most, const Scene& scene, const EnvironmentLight& light,
                          const PictureSettings& settings);

// The picture of the sphere scene under the environment, for a file of this format. A prediction that is asked for is
// told on stderr. In a PPM errors are grey, twice their root mean square white. Throws what picture, predicted_picture
// and samples_for throw, and UsageError for an RMSE under a sun (sun.h) where the light is not known: samples meet it
// by chance, and those that miss it do not know that it is there.
Image asked_picture(const EnvironmentMap& environment, PictureSettings settings, const Prediction& prediction,
                    Format format, const Progress& progress);
}  // namespace bmc
