// The errors of pictures of the sphere scene.
#pragma once

#include "scene/render.h"

namespace bmc {
// The picture by this number of directions on a lattice. Size, seed and threads are those of the settings.
Image reference_image(const EnvironmentMap& light, RenderSettings settings, std::size_t samples);

// The error of an image, over the pixels that show an object.
struct ImageError {
    double rmse;         // of linear radiance, all channels
    double correlation;  // of the errors of horizontally neighbouring pixels, less their mean; 0 where there are none
    double brightness;   // mean error over mean of the truth
};
ImageError image_error(const Image& image, const Image& truth);
}  // namespace bmc
