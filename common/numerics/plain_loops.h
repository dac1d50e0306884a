// renderer --plain sets this: the textbook's loops run in place of their fast twins (cholesky_fast, reflection_fast,
// known_light_fast). They are slower and give the same bits.
#pragma once

namespace bmc {
inline bool plain_loops = false;
}  // namespace bmc
