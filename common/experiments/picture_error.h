// What pictures of a scene differ from the truth by.
#pragma once

#include "numerics/portable_math.h"

#include <vector>

#include "scene/image.h"
#include "scene/scene.h"

// Which pixels show an object, row by row.
std::vector<bool> object_mask(const Scene& scene, int width, int height);

// What an image differs from the truth by, over the pixels that show an object.
struct ImageError {
    double rmse;         // of linear radiance, all channels
    double correlation;  // of the errors of horizontally neighbouring pixels, less their mean; 0 where there are none
    double brightness;   // mean error over mean of the truth
};
ImageError image_error(const std::vector<bool>& mask, const Image& image, const Image& truth);

// The fraction of the errors, colour by colour, that are at most twice the standard errors predicted for them.
double share_within_two(const std::vector<bool>& mask, const Image& image, const Image& truth, const Image& predicted);
