// What correct programs make of the scene.
#pragma once

#include "numerics/portable_math.h"

#include <string>
#include <vector>

#include "judge/picture_numbers.h"
#include "scene/render.h"

// As many pictures are enough to know how they spread.
constexpr std::size_t seeds = 40;

// The method, as one would type it.
std::string options_of(const RenderSettings& settings);

// Whether all pixels share one rule: a picture is then one sample.
bool shares_one_rule(const RenderSettings& settings);

// Makes pictures as a file with the largest code maxval keeps them, 0 for floats.
class Studio {
public:
    Studio(const EnvironmentMap& environment, int maxval) : light_(environment), maxval_(maxval) {}

    // The truth by a dense rule that knows the light, so that a sun does not spoil it; not clamped. Its size is that of
    // the settings.
    Image dense(RenderSettings settings) const;

    // Of so many pictures of the truth's size.
    std::vector<Numbers> numbers(RenderSettings settings, const Truth& truth, std::size_t count,
                                 const Progress& progress = nullptr) const;

private:
    const Scene scene_ = sphere_scene();
    const Light light_;
    int maxval_;
};
