#include "light/load_environment.h"

#include "base/input.h"
#include "base/terminal.h"

namespace bmc {
EnvironmentMap load_environment(const std::string& name, std::size_t threads) {
    for (std::size_t i = 0; i < std::size(built_in_lights); ++i)
        if (name == built_in_lights[i]) return built_in_light(static_cast<BuiltInLight>(i), threads);
    std::vector<std::string> notes;
    const auto read = [&](std::istream& in) { return read_radiance_hdr(in, notes); };
    EnvironmentMap map = read_file(name, read, "no such file, and not the name of a light: " + listed(light_names()));
    for (const std::string& note : notes) print_note("note: " + name + ": " + note);
    return map;
}
}  // namespace bmc
