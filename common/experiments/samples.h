// Samples in a file.
#pragma once

#include "base/vec3.h"

#include <iosfwd>
#include <vector>

namespace bmc {
// Directions, and the values that were measured there: none, or one for each.
struct Samples {
    std::vector<Vec3> directions;
    std::vector<double> values = {};
};

// Reads lines "x y z" or "x y z value", all of one kind; # begins a comment. Throws std::runtime_error that names the
// line for anything else, for a length that is not 1 within 1e-6, for a direction below the horizon, and for more than
// 4096 directions, 65535 lines or 4095 characters in a line; so a file without an end takes little memory. An error of
// reading is an exception, too.
Samples read_samples(std::istream& in);
}  // namespace bmc
