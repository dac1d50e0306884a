#include "beyond/known_light/picture.h"
#include "test.h"

using namespace bmc::beyond;

TEST_CASE("a picture is rendered by the light or, where that is known, by its averages") {
    const Scene scene = sphere_scene();
    const EnvironmentMap map = sunny_map();
    const PrefilteredEnvironment averages(map);
    for (const bool known : {false, true}) {
        const PictureSettings settings{small_picture(Method::rotated, 9), known};
        const PixelRules rules(known ? sky_settings(settings, averages) : RenderSettings(settings));
        const Shader shade = known ? known_light_shader(scene, averages, rules, sun_samples(averages, 9))
                                   : environment_shader(scene, map, rules);
        CAPTURE(known);
        CHECK(first_difference(picture(EnvironmentLight(map, known, 1), settings).pixels,
                               render(scene, map, settings, shade).pixels) == "");
    }
}
