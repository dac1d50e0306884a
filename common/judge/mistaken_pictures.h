// What the usual mistakes make of a picture, so that the one which a wrong picture shows can be named.
#pragma once

#include "numerics/portable_math.h"

#include <string>

#include "judge/picture_file.h"
#include "judge/picture_numbers.h"
#include "scene/environment.h"

// The mistake that makes of the dense truth, which is not clamped, what the picture is, up to noise, which leaves an
// RMSE of at most so much in correct pictures; an empty text if there is none. First those of a picture whose
// background is wrong, then those that the objects alone show.
std::string mistake_of_whole(const PictureFile& picture, const Truth& dense, double rmse);
std::string mistake_of_objects(const PictureFile& picture, const Truth& dense, const EnvironmentMap& environment,
                               std::size_t samples, double rmse);
