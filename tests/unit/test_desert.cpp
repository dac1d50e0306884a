#include "light/load_environment.h"
#include "test.h"

TEST_CASE("black and white is light from every direction with x > 0") {
    const EnvironmentMap map = load_environment("black-and-white");
    for (const Vec3& w : all_around(1000))  // a column is 0.006 wide
        if (std::fabs(w.x) > 0.01) CHECK_MESSAGE(map.radiance(w).y == (w.x > 0), w);
}

TEST_CASE("an error in the file of a light names the file") {
    const TemporaryFile bad("P6");
    CHECK(message_of([&] { load_environment(bad.name); }) ==
          bad.name + ": not a Radiance picture, whose first line begins with #?; `oiiotool in -o out.hdr` converts it");
    CHECK(message_of([&] { load_environment("no such file"); }) ==
          "no such file: no such file, and not a built-in light (desert, bright-desert, black-and-white)");
}
