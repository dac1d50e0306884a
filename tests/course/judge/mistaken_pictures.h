// What the usual mistakes make of a picture, so that the one which a wrong picture shows can be named.
#pragma once

#include "experiments/picture_error.h"
#include "picture_file.h"

#include <string>

// The mistake that makes of the dense truth, which is not clamped, what the picture is, up to an RMSE that noise leaves
// in correct pictures; or an empty text. Those of a picture whose background is wrong, and those of objects alone.
std::string mistake_of_whole(const PictureFile& picture, const Truth& dense, double rmse);
std::string mistake_of_objects(const PictureFile& picture, const Truth& dense, const EnvironmentMap& environment,
                               std::size_t samples, double rmse);
