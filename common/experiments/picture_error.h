// What pictures of a scene differ from the truth by.
#pragma once

#include "numerics/portable_math.h"

#include <vector>

#include "scene/image.h"
#include "scene/scene.h"

// What images differ from the truth by, over the pixels that show an object.
struct ImageError {
    double rmse, correlation, brightness;
};
ImageError image_error(const Scene& scene, const std::vector<Image>& images, const Image& truth);
