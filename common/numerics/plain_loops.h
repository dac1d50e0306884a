// Whether the textbook's loops run where a fast twin of them exists (cholesky_fast, reflection_fast): renderer --plain.
// They take longer and give the same bits.
#pragma once

namespace bmc {
inline bool plain_loops = false;
}  // namespace bmc
