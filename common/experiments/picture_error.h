// The errors of pictures of the sphere scene.
#pragma once

#include "picture.h"

#include <vector>

namespace bmc {
struct Truth {
    Image image;
    std::vector<bool> mask;  // which pixels show an object, row by row

    bool shows_object(int x, int y) const { return mask[static_cast<std::size_t>(y * image.width() + x)]; }
};

// A picture of the sphere scene as the truth.
Truth truth_of(Image image);

// The picture by so many directions on a lattice and, for its bright texels (sun.h), so many rays to them. Nothing is
// from a table of the light. Size, seed and threads are those of the settings.
Truth dense_truth(const EnvironmentLight& light, PictureSettings settings, std::size_t samples);

// The error of an image, over the pixels that show an object.
struct ImageError {
    double rmse;         // of linear radiance, all channels
    double correlation;  // of the errors of horizontally neighbouring pixels, less their mean; 0 where there are none
    double brightness;   // mean error over mean of the truth
};
ImageError image_error(const Image& image, const Truth& truth);

// The fraction of the errors, colour by colour, that are at most twice the standard errors predicted for them.
double coverage(const Image& image, const Truth& truth, const Image& predicted);
}  // namespace bmc
