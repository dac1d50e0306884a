#include "light/environment.h"
#include "test.h"

TEST_CASE("black and white is light from every direction with x > 0") {
    const EnvironmentMap map = load_environment("black-and-white");
    for (const Vec3& w : all_around(1000))  // a column is 0.006 wide
        if (std::fabs(w.x) > 0.01) CHECK_MESSAGE(map.radiance(w).y == (w.x > 0), w);
}
