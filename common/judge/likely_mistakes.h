// What the usual mistakes make of a picture, so that the one which a wrong picture shows can be named.
#pragma once

#include "numerics/portable_math.h"

#include <string>
#include <vector>

#include "scene/environment.h"
#include "scene/image.h"
#include "scene/scene.h"

// Every pixel whose column and row leave the remainder step / 2 when divided by step, at most the smaller side; and of
// a mask of width x height pixels.
Image thinned(const Image& image, int step);
std::vector<bool> thinned(const std::vector<bool>& mask, int width, int height, int step);

// The mistake that makes of the truth what the picture is: in the background, which has no noise, or else, if
// that fits, in the objects; an empty text if none comes clearly closer than the truth. The truth is not clamped;
// maxval is that of the picture.
std::string likely_mistake(const EnvironmentMap& environment, const Image& picture, int maxval, const Image& truth,
                           std::size_t samples, bool background_fits);
