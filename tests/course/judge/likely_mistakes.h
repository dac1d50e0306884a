// The usual mistakes by which a picture or a column of a table is off: for the judge, and for the comparison with a
// reference.
#pragma once

#include "numerics/portable_math.h"

#include <cmath>
#include <string>

struct Mirroring {
    const char* name;
    bool left_right, up_down;
};
constexpr Mirroring mirrorings[] = {
    {"upside down", false, true}, {"mirrored, left for right", true, false}, {"turned by 180 degrees", true, true}};

struct Factor {
    const char* name;
    double factor;
};
constexpr Factor factors[] = {{"1 / pi is missing, or pi too often", portable::pi},
                              {"divided by pi once too often", 1 / portable::pi},
                              {"2 pi too often", 2 * portable::pi},
                              {"2 pi is missing", 1 / (2 * portable::pi)},
                              {"weights pi / N in place of 2 pi / N", 0.5},
                              {"weights 4 pi / N in place of 2 pi / N, or added twice", 2}};

// Which of the known factors, nearest and within a relative tolerance, it is; or an empty text.
inline std::string factor_name(double factor, double tolerance) {
    std::string name;
    for (const Factor& each : factors) {
        const double off = std::fabs(factor / each.factor - 1);
        if (off > tolerance) continue;
        name = each.name;
        tolerance = off;
    }
    return name;
}
