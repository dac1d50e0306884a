// Radiance pictures (.hdr): how environment maps are stored in files.
#pragma once

#include "scene/environment.h"

#include <iosfwd>
#include <string>

namespace bmc {
// Reads a Radiance picture (.hdr, RGBE; Ward, "Real Pixels", Graphics Gems II, 1991) from a binary stream: linear RGB
// radiance = mantissa * 2^(exponent - 136), exactly. Scanlines may be flat or run-length coded in the old or new way;
// the resolution line must be "-Y height +X width". EXPOSURE is ignored, as the practice's loader does. Memory beyond
// 12 MiB follows what the file holds, not what its header claims. Throws std::runtime_error whose text is one line:
// what is wrong and, within the picture, in which row (0 at the top).
EnvironmentMap read_radiance_hdr(std::istream& in);

// The map as such a picture, flat scanlines: each radiance rounded to a multiple of 2^(exponent - 136), where the
// largest of its texel has a mantissa of at least 128; clamped from 2^127.
std::string to_radiance_hdr(const EnvironmentMap& map);
}  // namespace bmc
