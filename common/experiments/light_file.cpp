#include "experiments/reports.h"

namespace bmc {
std::string LightFile::report() const {
    const EnvironmentMap map = load_environment(environment);
    Image image(map.width, map.height);
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) image(x, y) = map.colour(map.index(x, y));
    return encode(image, Format::pfm);
}
}  // namespace bmc
