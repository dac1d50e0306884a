#include "light/load_environment.h"

#include "light/radiance_hdr.h"

#include <fstream>
#include <stdexcept>

namespace bmc {
EnvironmentMap load_environment(const std::string& name, std::size_t threads) {
    for (std::size_t i = 0; i < std::size(built_in_lights); ++i)
        if (name == built_in_lights[i]) return built_in_light(i, threads);
    std::ifstream file(name, std::ios::binary);
    if (!file)
        throw std::runtime_error(name + ": no such file, and not a built-in light (desert, bright-desert, " +
                                 "black-and-white)");
    try {
        return read_radiance_hdr(file);
    } catch (const std::ios_base::failure&) {
        throw std::runtime_error(name + ": this file cannot be read to its end");
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(name + ": " + error.what());
    }
}
}  // namespace bmc
