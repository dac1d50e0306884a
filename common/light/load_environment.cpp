#include "light/load_environment.h"

#include "light/desert.h"
#include "light/radiance_hdr.h"

#include <fstream>
#include <stdexcept>

namespace bmc {
EnvironmentMap load_environment(const std::string& name, unsigned threads) {
    if (name == built_in_lights[0]) return desert(threads);
    if (name == built_in_lights[1]) return bright_desert(threads);
    if (name == built_in_lights[2]) return black_and_white(threads);
    std::ifstream file(name, std::ios::binary);
    if (!file)
        throw std::runtime_error(name + ": no file that can be read has this name, and no built-in light: they are " +
                                 "desert, bright-desert and black-and-white");
    try {
        return read_radiance_hdr(file);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(name + ": " + error.what());
    }
}
}  // namespace bmc
