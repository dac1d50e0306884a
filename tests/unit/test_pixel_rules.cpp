#include "scene/pixel_rules.h"
#include "test.h"

TEST_CASE("a pixel's random stream has the number of the pixel, row after row") {
    RenderSettings settings = small_picture(Method::mc, 1, 1 << 17);
    settings.height = 70000;
    settings.seed = 5;
    CHECK(pixel_stream(settings, 3, 1 << 16).bits() == Random(5, (std::uint64_t{1} << 33) + 3).bits());
}
