#include "light/desert.h"

#include "test.h"

TEST_CASE("the built-in environment is a picture of 1024 x 512 radiances in [0, 1], always the same") {
    const std::vector<float> first = values(desert);
    REQUIRE(first.size() == 3 * 1024 * 512);
    CHECK(first == values(load_environment()));
    CHECK(*std::min_element(first.begin(), first.end()) >= 0);
    CHECK(*std::max_element(first.begin(), first.end()) <= 1);
}

TEST_CASE("the bright desert is the desert, but for its sun a thousand times as bright") {
    const EnvironmentMap bright_desert = load_environment("bright-desert");
    const std::vector<float> even = values(desert), bright = values(bright_desert);
    int changed = 0, darker = 0;
    for (std::size_t i = 0; i < even.size(); i += 3) {
        changed += bright[i] != even[i];
        darker += bright[i] < even[i];
    }
    CHECK(darker == 0);
    // A disc of radius acos(1 - 2 (1 - 0.9976)) = 5.6 degrees at an elevation of 29 degrees: pi 5.6^2 of texels that
    // are 360 / 1023 by 180 / 511 degrees wide, over cos(29 degrees).
    CHECK(changed > 860);
    CHECK(changed < 960);
    const Vec3 sun{0.8, 0.48, 0.36};
    CHECK(std::fabs(bright_desert.radiance(sun).x / desert.radiance(sun).x - 1000) < 1e-3);
}

TEST_CASE("black and white is light from every direction with x > 0, and none from elsewhere") {
    const EnvironmentMap map = load_environment("black-and-white");
    Random random(1, 0);
    for (const Vec3& w : uniform_directions(1000, random)) {
        if (std::fabs(w.x) < 0.01) continue;  // a column is 0.006 wide
        CHECK(map.radiance(w).x == (w.x > 0 ? 1 : 0));
        CHECK(map.radiance(-1 * w).z == (w.x > 0 ? 0 : 1));
    }
    for (const char* name : built_in_lights) CHECK(load_environment(name).width() == 1024);
}
