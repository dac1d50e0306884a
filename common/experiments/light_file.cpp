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
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = map.colour(static_cast<int>(i) + 1);
    return encode(image, Format::pfm);
}
}  // namespace bmc
