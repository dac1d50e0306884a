// The function factor of cholesky.cpp, faster and with the same bits.
#pragma once

#include "numerics/matrix.h"

namespace bmc {
void factor_fast(Matrix& u);
}  // namespace bmc
