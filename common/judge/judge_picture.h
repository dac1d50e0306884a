// Whether a picture of the sphere scene, made by whatever program with whatever random numbers, is what a correct one
// makes: its numbers beside those of correct pictures with other seeds.
//
// A method that shares rules between pixels errs alike in many of them, so what one picture may differ by is the spread
// over seeds, not over pixels.
#pragma once

#include "numerics/portable_math.h"

#include <string>
#include <vector>

#include "judge/picture_file.h"
#include "scene/render.h"

// A number of the picture, the mean and the standard deviation of correct pictures', and the range that is accepted.
struct Quantity {
    const char* name;
    double here, expected, spread, low, high;

    bool fits() const { return here >= low && here <= high; }
};

struct PictureJudgement {
    // Background: the fraction of its pixels that differ. Then RMSE, brightness and correlation as image_error has
    // them, alike neighbours, and block, the largest error of the mean over a block of pixels; "together", how far
    // these are from those of correct pictures in standard deviations of all at once. Last "unlike": the logarithm of
    // how many times likelier such numbers are with another method; were the densities exact, a correct picture would
    // exceed 10 with a probability of at most e^-10 for each of them. Correct pictures that exceed it raise it.
    std::vector<Quantity> quantities;
    int block_x, block_y;   // the centre of that block
    std::string resembles;  // the method whose pictures have such numbers most likely, as options; or empty
    std::string mistake;    // a likely one if not all quantities fit and the numbers tell; or empty

    bool fits() const;
    bool fits(const std::string& quantity) const;
};

// The picture against those of the settings, whose size and seed are not used. Throws std::invalid_argument if too few
// pixels show an object, or the environment lights none.
PictureJudgement judge_picture(const Picture& picture, const EnvironmentMap& environment,
                               const RenderSettings& settings, const Progress& progress = nullptr);
