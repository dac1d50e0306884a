// Pictures of the sphere scene that tests compare.
#pragma once

#include "experiments/picture_error.h"
#include "scene/desert.h"
#include "scene/render.h"

inline const Method all_methods[] = {Method::mc, Method::direct, Method::single, Method::rotated, Method::pool};

inline RenderSettings small(Method method, std::size_t samples = 40, int size = 40) {
    RenderSettings settings;
    settings.method = method;
    settings.samples = samples;
    settings.width = settings.height = size;
    return settings;
}

inline const EnvironmentMap desert = load_environment("desert");

// What pictures tend to: plain weights on a dense lattice.
inline Image dense_picture(const EnvironmentMap& environment, int size = 40) {
    RenderSettings settings = small(Method::mc, 20000, size);
    settings.placement = Placement::fibonacci;
    settings.threads = 2;
    return render(sphere_scene(), environment, settings);
}

inline ImageError error_of(const Image& image, const Image& truth) { return image_error(image, truth_of(truth)); }
