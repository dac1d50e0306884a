// What accuracy costs: the time and the error of an integral and of a picture, for every method and number of samples.
// Errors are functions of the arguments; seconds are measured and differ from run to run.
#pragma once

#include "experiments/command.h"
#include "experiments/integrands.h"
#include "scene/render.h"

#include <string>
#include <vector>

// Median seconds of each stage between drawing a sample set and having an estimate.
struct StageTimes {
    double draw, covariance, factor, z, weights, estimate;

    double rule() const { return draw + covariance + factor + z + weights; }
};

struct IntegralCost {
    std::size_t samples;
    double mc_error, bmc_error;  // root mean square over fresh sets
    StageTimes seconds;          // zero unless timed

    // Samples with which Monte Carlo would have the error of Bayesian Monte Carlo.
    double equivalent_mc_samples() const;

    // Integrals after which a rule made once has cost less time than Monte Carlo at equal error; an estimate of Monte
    // Carlo draws its directions afresh.
    double integrals_to_pay_off() const;
};

// Sobolev 3/2, noise 0.01, on the integrand.
std::vector<IntegralCost> integral_costs(const Integrand& integrand, bool timed);

// One method: errors over several seeds, as many as make them the method's and not the seed's. A method that shares
// rules between pixels has as many independent rules as seeds, not as pixels.
struct PictureCost {
    RenderSettings settings;
    double rmse;                   // of linear radiance, over the pixels that show an object, all channels and seeds
    double rmse_error;             // standard error of rmse
    double correlation;            // of the errors of horizontally neighbouring pixels, mean over the seeds
    double brightness;             // root mean square over the seeds of ImageError::brightness
    double seconds_per_megapixel;  // for a million pixels that show an object, on one core; zero unless timed
};

// mc, direct, single, rotated and pools of 1, 2, 5 and 20, on uniform and Fibonacci directions; then mc on
// cosine-distributed directions and pools of 20 for every prior on the directions that suit it, and last with the light
// known; each with 10, 20, 40, 80 and 160 samples. Throws std::invalid_argument if the environment lights no object:
// there is nothing to compare. progress is told the fraction that is done.
std::vector<PictureCost> picture_costs(const EnvironmentMap& environment, int size, bool timed,
                                       const Progress& progress = nullptr);

struct Tradeoff {
    std::string environment;  // empty: the built-in one
    int size = 64;
    bool timed = true;

    std::vector<Option> options();
    std::string report() const;
};
