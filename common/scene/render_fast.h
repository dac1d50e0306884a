// The rows of a picture, bit for bit as render.cpp computes them pixel by pixel from reflection.h and known_light.h.
//
// The pixels of a row go in blocks: first the hits and frames of a block, then the directions, shadows and texels of
// all its rays in arrays, each texel asked for as soon as its place is known, so that no sum waits for memory; last the
// sums, those of four pixels side by side, each in the plain order.
#pragma once

#include "scene/image.h"
#include "scene/pixel_rules.h"

#include <functional>

// Renders row y and returns how many of its pixels show an object.
using RenderRow = std::function<std::size_t(int y, Image& image)>;

// The same as the plain one, which remains for Monte Carlo in parts (render.cpp). All arguments must outlive it; it
// holds the shared rules that there are now.
RenderRow rows_fast(const RenderRow& plain, const Scene& scene, const Light& light, const RenderSettings& settings,
                    const PixelRules& rules);
