// What correct programs make of the scene: the numbers of their pictures, and how these spread over seeds.
#pragma once

#include "numerics/portable_math.h"

#include <array>
#include <string>
#include <vector>

#include "judge/picture_file.h"
#include "scene/render.h"

// What a picture differs from the truth by: RMSE, brightness, correlation, alike neighbours, largest block error.
constexpr std::size_t quantity_count = 5;
using Numbers = std::array<double, quantity_count>;

// A scale on which the spread of a number over seeds is about normal: errors by their logarithms, correlations by those
// of their distances to 0 and 1. The floor is the least deviation that is allowed for: correct programs differ in their
// frames and roundings, and the largest of many errors has a long tail.
struct Scale {
    const char* name;
    double (*to)(double);
    double (*from)(double);
    double floor;
};
extern const Scale scales[quantity_count];

// Numbers on their scale.
struct Spread {
    double mean = 0, deviation = 0;  // the deviation of a new number from the mean of these

    Spread(const std::vector<Numbers>& all, std::size_t which);
};

// The truth at one size.
struct Truth {
    Image image;
    std::vector<bool> mask;  // which pixels show an object

    Numbers numbers(const Image& picture) const;
    int block_side() const;
};

// A way to render, the size and the seed apart.
struct Candidate {
    std::string name;  // its options
    RenderSettings settings;
    bool turns = true;  // false: a pool that is not turned
};

// Of the method, as one would type them.
std::string options_of(const RenderSettings& settings);

// Whether all pixels share one rule: a picture is then one sample.
bool shares_one_rule(const RenderSettings& settings);

// The settings themselves first, then every other method and number of samples, and the settings' pool, not turned.
std::vector<Candidate> candidates_for(const RenderSettings& settings);

// Makes pictures as a file with the largest code maxval keeps them, 0 for floats.
class Studio {
public:
    Studio(const EnvironmentMap& environment, int maxval, const Progress& progress)
        : light_(environment), maxval_(maxval), progress_(progress) {}

    // A dense rule that knows the light, so that a sun does not spoil it; its size is that of the settings.
    Image dense(RenderSettings settings);

    // A dense image, clamped where a file is.
    Truth truth(const Image& dense) const;

    // Of so many pictures of the truth's size, each with a seed of its own.
    std::vector<Numbers> numbers(const Candidate& candidate, const Truth& truth, std::size_t seeds);

    // About how many rays of a shared rule take the time of one picture; and what the progress is told of.
    static double rays(const Candidate& candidate, int width, int height);
    void expect(double rays) { all_rays_ += rays; }
    void finish() const {
        if (progress_) progress_(1);
    }

private:
    Image picture(const RenderSettings& settings) const;
    Image unturned_pool(RenderSettings settings) const;
    void count(double rays);

    const Scene scene_ = sphere_scene();
    const Light light_;
    int maxval_;
    const Progress& progress_;
    double done_rays_ = 0, all_rays_ = 0;
};

// Leaves an RMSE of 0.0003, where 40 samples of the best method leave 0.005; of 0.02 under the sun of bright-desert,
// where they leave 0.17.
constexpr std::size_t dense_samples = 2000;
