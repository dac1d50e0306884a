// The choice between the built-in lights and a light from a file.
#pragma once

#include "light/environment.h"

#include <string>

namespace bmc {
constexpr const char* built_in_lights[] = {"desert", "bright-desert", "black-and-white"};  // desert.h describes them

// The help text of an option that takes the name of a light.
constexpr const char* environment_help = "a Radiance .hdr file, bright-desert, black-and-white (default desert)";

// The built-in light of this name, or else the one in the .hdr file. threads: how many to use. Throws
// std::runtime_error, one line that names the file.
EnvironmentMap load_environment(const std::string& name = "desert", unsigned threads = 1);
}  // namespace bmc
