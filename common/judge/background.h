// What a picture shows where it shows no object: the environment, without noise, so it tells how a program writes
// codes.
#pragma once

#include "numerics/portable_math.h"

#include "judge/picture_file.h"
#include "judge/picture_numbers.h"
#include "scene/environment.h"

// How the background's codes differ from those that they should be. Of floats, 128 values to the largest channel of a
// pixel count as codes: radiance in a Radiance picture has no more.
struct Background {
    double differing;  // fraction of the pixels with a code off by more than 1.5
    double accepted;   // of that fraction
    double offset;     // mean of what the others lack: 1/2 where a program rounds down; 0 for floats
};

// Against the environment interpolated, as the truth has it, or its single texels, as the practice's lookup gives:
// whichever the picture is closer to.
Background background_of(const PictureFile& picture, const Truth& truth, const EnvironmentMap& environment);

// A picture of codes as it was before its program rounded it in its own way.
Image unrounded(Image image, int maxval, double offset);
