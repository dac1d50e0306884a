// The functions factor and Cholesky::inverse of cholesky.h, faster and with the same bits.
#pragma once

#include "numerics/matrix.h"

namespace bmc {
void factor_fast(Matrix& a);

Matrix inverse_fast(const Matrix& upper);
}  // namespace bmc
