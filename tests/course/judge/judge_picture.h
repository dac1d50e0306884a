// Whether a picture of the sphere scene, made by whatever program with whatever random numbers, is what a correct one
// makes: its numbers beside those of correct pictures with other seeds.
#pragma once

#include "picture_file.h"
#include "picture_numbers.h"

#include <string>

// The method, as one would type it.
std::string options_of(const PictureSettings& settings);

struct PictureJudgement {
    Comparison comparison;  // first "background", the fraction of its pixels that differ
    BlockError block;
    std::string mistake;  // likely ones if not all quantities fit; empty if none explains the picture

    bool fits() const { return comparison.fits(); }
};

// The picture against those of the settings, whose size and seed are not used. Throws std::invalid_argument if too few
// pixels show an object, or the environment lights none.
PictureJudgement judge_picture(const PictureFile& picture, const EnvironmentMap& environment,
                               const PictureSettings& settings, const Progress& progress = nullptr);
