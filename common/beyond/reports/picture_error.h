// The errors of pictures of the sphere scene.
#pragma once

#include "beyond/prediction/picture.h"

namespace bmc {
// The picture by this number of directions on a lattice and the same number of rays to bright texels (sun.h). Nothing
// is from a table of the light. Size, seed and threads are those of the settings.
Image dense_truth(const EnvironmentMap& environment, PictureSettings settings, std::size_t samples);

// The error of an image, over the pixels that show an object.
struct ImageError {
    double rmse;         // of linear radiance, all channels
    double correlation;  // of the errors of horizontally neighbouring pixels, less their mean; 0 where there are none
    double brightness;   // mean error over mean of the truth
};
ImageError image_error(const Image& image, const Image& truth);

// The fraction of the errors, colour by colour, that are at most twice the standard errors predicted for them.
double coverage(const Image& image, const Image& truth, const Image& predicted);
}  // namespace bmc
