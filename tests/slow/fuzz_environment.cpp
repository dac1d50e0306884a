// libFuzzer: any bytes are a map of radiances or an error of one line.
#include "scene/environment.h"
#include "scene/radiance_hdr.h"

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

using namespace bmc;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    std::istringstream in(std::string(bytes, bytes + size));
    try {
        const EnvironmentMap map = read_radiance_hdr(in);
        const Color corner = map.radiance({0, -1, 0});
        if (!(corner.x >= 0 && corner.y >= 0 && corner.z >= 0)) std::abort();
    } catch (const std::runtime_error& error) {
        const std::string text = error.what();
        if (text.empty() || text.find('\n') != std::string::npos) std::abort();
    }
    return 0;
}
