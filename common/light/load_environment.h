// The choice between the built-in lights and a light from a file, and what such a file is.
#pragma once

#include "base/formatted.h"
#include "light/environment.h"

#include <iosfwd>
#include <string>

namespace bmc {
// The built-in lights are maps of 1024 x 512 texels:
// - desert: an arch of sandstone around -z and the sun high on the right, behind a camera that looks at the arch;
//   radiance in [0, 1].
// - bright-desert: the same with a sun a thousand times as bright, as real suns are: it sends four fifths of the light.
// - black-and-white: the hardest light without a sun: radiance 1 where x > 0, and 0 elsewhere.
enum class BuiltInLight { desert, bright_desert, black_and_white };
constexpr const char* built_in_lights[] = {"desert", "bright-desert", "black-and-white"};
EnvironmentMap built_in_light(BuiltInLight light, std::size_t threads = 1);

// Reads a Radiance picture (.hdr; Ward, "Real Pixels", Graphics Gems II, 1991) from a binary stream, of the usual kind:
// 32-bit_rle_rgbe, rows from the top left, flat or run-length coded. Linear RGB radiance = mantissa * 2^(exponent -
// 136), exactly, over the product of the EXPOSURE lines. Memory grows with what the file holds. Throws
// std::runtime_error: one line with the problem, and what converts a picture of another kind.
EnvironmentMap read_radiance_hdr(std::istream& in);

inline std::vector<std::string> light_names() { return {std::begin(built_in_lights), std::end(built_in_lights)}; }

// The help text of an option that takes the name of a light.
inline std::string environment_help() { return "a .hdr (-: stdin), " + listed(light_names()) + " (default desert)"; }

// The built-in light of this name, or else the one in the .hdr file; "-" is standard input. threads: how many to use.
// Throws std::runtime_error, one line that names the file.
EnvironmentMap load_environment(const std::string& name = "desert", std::size_t threads = 1);
}  // namespace bmc
