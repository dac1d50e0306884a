// The pixels that show an object.
#pragma once

#include "scene/scene.h"

namespace bmc {
// Calls f(x, y, hit) for each of them, row after row.
template <class Function>
void for_each_hit(const Scene& scene, const Camera& camera, Function f) {
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            if (const std::optional<Hit> hit = intersect(scene, camera.ray(x, y))) f(x, y, *hit);
}

// Their number.
inline double object_pixels(const Scene& scene, const Camera& camera) {
    double count = 0;
    for_each_hit(scene, camera, [&](int, int, const Hit&) { ++count; });
    return count;
}
}  // namespace bmc
