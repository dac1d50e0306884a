// What the accuracy of a picture costs: the sphere scene by every method against a dense quadrature.
#pragma once

#include "beyond/prediction/prediction.h"

namespace bmc {
struct CostSettings {
    int size = 64;           // of the pictures, size x size pixels
    std::uint64_t seed = 1;  // picture i of seed k has the seed 1000 (k - 1) + i, i from 1
    bool timed = true;
};

// Errors over several seeds: if pixels share rules, there are as many independent errors as seeds, not as pixels.
struct PictureCost {
    PictureSettings settings;
    double rmse;                   // of linear radiance, over the pixels that show an object, all channels and seeds
    double rmse_error;             // standard error of rmse
    double predicted, coverage;    // RMSE that two pictures predict; fraction of errors within two predicted ones
    double correlation;            // of the errors of horizontally neighbouring pixels, mean over the seeds
    double brightness;             // root mean square over the seeds of ImageError::brightness
    double seconds_per_megapixel;  // for a million pixels that show an object, on one processor; 0 unless timed
};

// The settings that are compared, except for the number of samples, classic Monte Carlo first. With all, also the
// others of the figure on the wing's page.
std::vector<PictureSettings> compared_settings(bool all = false);

// The seconds of one call: the least of four measurements, which take at least 2 ms each.
double seconds_of(const std::function<void()>& action);

// Each of the settings with each number of samples. Throws std::invalid_argument if the environment lights no object:
// then there is nothing to compare.
std::vector<PictureCost> picture_costs(const EnvironmentMap& environment, const std::vector<PictureSettings>& compared,
                                       const std::vector<std::size_t>& samples, const CostSettings& costs);

// A row for each picture; the first settings are classic Monte Carlo's.
std::string picture_table(const std::vector<PictureCost>& rows, bool timed);
}  // namespace bmc
