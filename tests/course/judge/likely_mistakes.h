// The usual mistakes in pictures and tables: for the judge, and for the comparison with a reference.
#pragma once

#include "numerics/portable_math.h"

namespace bmc {
struct Factor {
    const char* name;
    double factor;
};
constexpr Factor factors[] = {{"1 / pi is missing, or pi too often", portable::pi},
                              {"divided by pi once too often", 1 / portable::pi},
                              {"weights pi / N in place of 2 pi / N", 0.5},
                              {"weights 4 pi / N in place of 2 pi / N, or added twice", 2},
                              {"2 pi too often", 2 * portable::pi},
                              {"2 pi is missing", 1 / (2 * portable::pi)}};
}  // namespace bmc
