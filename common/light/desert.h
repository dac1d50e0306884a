// The built-in lights.
#pragma once

#include "light/environment.h"

namespace bmc {
// Maps of 1024 x 512 texels of linear RGB radiance. threads: how many to use.

// An arch of sandstone around -z and the sun high on the right, behind a camera that looks at the arch; radiance in
// [0, 1].
EnvironmentMap desert(unsigned threads);

// The same with a sun a thousand times as bright, as real suns are: it sends four fifths of the light.
EnvironmentMap bright_desert(unsigned threads);

// The hardest light without a sun: radiance 1 where x > 0, and 0 elsewhere.
EnvironmentMap black_and_white(unsigned threads);
}  // namespace bmc
