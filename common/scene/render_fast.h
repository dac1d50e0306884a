// The rows of a picture, bit for bit as render.cpp computes them pixel by pixel from reflection.h and known_light.h.
//
// The pixels of a row go in blocks: first the hits and frames of a block, then the directions, shadows and texels of
// all its rays in arrays, each texel asked for as soon as its place is known, so that no sum waits for memory; last the
// sums, those of four pixels side by side, each in the plain order.
#pragma once

#include "scene/image.h"
#include "scene/pixel_rules.h"

#include <functional>

// Renders row y. All arguments of rows_fast must outlive what it returns, which holds the shared rules that there are
// now.
using RenderRow = std::function<void(int y, Image& image)>;
RenderRow rows_fast(const Scene& scene, const Light& light, const RenderSettings& settings, const PixelRules& rules);
