// What the comparisons of texts and of pictures share.
#pragma once

#include "base/formatted.h"

#include <cmath>
#include <string>

// Whether a number may stand in the place of the reference's. A tolerance is relative, plus 1e-9; 0 tolerates nothing.
inline bool agree(double reference, double actual, double tolerance) {
    return reference == actual ||
           (tolerance > 0 && std::fabs(actual - reference) <= tolerance * std::fabs(reference) + 1e-9);
}

inline std::string count_of(std::size_t differing, std::size_t all, const char* what) {
    return bmc::formatted("%zu of %zu %s %s", differing, all, what, differing == 1 ? "differs" : "differ");
}

// In words, what does not agree; empty if all does. The reference of a picture begins with P.
std::string text_difference(const std::string& reference, const std::string& actual, double tolerance);
std::string picture_difference(const std::string& reference, const std::string& actual, double tolerance);
