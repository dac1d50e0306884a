#include "light/texels_on_sphere.h"
#include "test.h"

TEST_CASE("the pieces of a map cover the sphere once, each within its texel") {
    for (const auto& [width, height] : {std::pair(1, 1), {9, 5}, {40, 1}}) {
        const EnvironmentMap map = coloured_map(width, height);
        const TexelsOnSphere texels(map, 20, 10);
        CHECK(texels.columns >= 20);
        CHECK(texels.rows >= 10);
        CAPTURE(map.width);
        double all = 0;
        for (int row = 0; row < texels.rows; ++row) {
            all += texels.columns * texels.solid_angle(row);
            for (int column = 0; column < texels.columns; ++column)
                CHECK(texels(row, column) ==
                      map.radiance(direction_of(texels.polar(row + 0.5), texels.azimuth(column + 0.5))));
        }
        CHECK(relative(all, 4 * pi) < 1e-14);
    }
}
