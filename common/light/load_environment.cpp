#include "light/load_environment.h"

#include "base/input.h"

namespace bmc {
EnvironmentMap load_environment(const std::string& name, std::size_t threads) {
    for (std::size_t i = 0; i < std::size(built_in_lights); ++i)
        if (name == built_in_lights[i]) return built_in_light(static_cast<BuiltInLight>(i), threads);
    return read_file(name, read_radiance_hdr, "no such file, and not the name of a light: " + listed(light_names()));
}
}  // namespace bmc
