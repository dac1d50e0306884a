// Radiance pictures (.hdr): how environment maps are stored in files.
#pragma once

#include "light/environment.h"

#include <iosfwd>
#include <string>

namespace bmc {
// Reads a Radiance picture (.hdr, RGBE; Ward, "Real Pixels", Graphics Gems II, 1991) from a binary stream: linear RGB
// radiance = mantissa * 2^(exponent - 136), exactly, over the product of the EXPOSURE and COLORCORR lines. Scanlines
// may be flat or run-length coded, but not in the way of before 1991; the resolution line must be "-Y height +X width".
// Memory grows with what the file holds. Adds notes, a line each, of what was not as it should be. Throws
// std::runtime_error: one line with the problem, and with what converts a picture of another kind.
EnvironmentMap read_radiance_hdr(std::istream& in, std::vector<std::string>& notes);
}  // namespace bmc
