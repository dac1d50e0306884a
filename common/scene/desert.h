// The lights that the project brings along, and the choice between them and one from a file.
#pragma once

#include "scene/environment.h"

#include <string>
#include <vector>

// A desert with an arch of sandstone around -z and the sun high on the right, behind a camera that looks at the arch:
// 1024 x 512 texels of linear RGB radiance in [0, 1].
EnvironmentMap built_in_environment();

// The same with a sun a thousand times brighter, as a real one is or more: it sends five sixths of the light.
EnvironmentMap bright_desert();

// desert, bright-desert, black-and-white.
std::vector<std::string> built_in_lights();

// The environment of a name: a built-in light, a .hdr file, or the desert if the name is empty. Throws
// std::runtime_error, one line that names the file.
EnvironmentMap load_environment(const std::string& name);

// What a help text says of the name.
constexpr const char* environment_help =
    "light from a Radiance .hdr file, bright-desert (its sun a thousand times brighter) or black-and-white (half of "
    "the directions bring light)";
