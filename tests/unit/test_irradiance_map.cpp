#include "beyond/known_light/irradiance_map.h"
#include "test.h"

using namespace bmc::beyond;

// The integral of (1 + w.d) cos(theta) is pi + (2 pi / 3) n.d.
TEST_CASE("the irradiance is the integral of L cos(theta) within 1e-3, for any size of map") {
    const Vec3 d{0.48, -0.64, 0.6};
    const IrradianceMap linear(map_of(301, 151,
                                      [&](int x, int y) {
                                          return Color{1 + dot(towards((x + 0.5) / 300, (y + 0.5) / 150), d), 1, 0};
                                      }),
                               2),
        one_texel(even_map(1, 1, 1)), one_column(even_map(1, 7, 1));
    std::vector<Vec3> normals = all_around(100);
    normals.insert(normals.end(),
                   {{0, 1, 0}, {0, -1, 0}, {0, 0, 1}, normalize({1e-6, 0, 1}), normalize({-1e-6, 0, 1})});
    for (const Vec3& n : normals) {
        CAPTURE(n);
        CHECK(std::fabs(linear(n).x - (pi + 2 * pi / 3 * dot(n, d))) < 1e-3 * 5 * pi / 3);
        for (const double even : {linear(n).y, one_texel(n).z, one_column(n).x}) CHECK(relative(even, pi) < 1e-3);
    }
}
