#include "experiments/reports.h"

#include "light/environment.h"
#include "scene/image.h"

namespace bmc {
std::string light_file(Arguments& arguments) {
    std::string environment = built_in_lights[0];
    arguments.add("environment", "FILE", environment_help(), environment);
    arguments.take("desert.pfm");
    const EnvironmentMap map = load_environment(environment);
    Image image(map.width, map.height);
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x) image(x, y) = map.colour(map.index(x, y));
    return encode(image, Format::pfm);
}
}  // namespace bmc
