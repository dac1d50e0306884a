#include "beyond/prediction/picture.h"
#include "test.h"

TEST_CASE("what is known is nothing, the cosine, or the light, with which the cosine is known, too") {
    PictureSettings settings;
    for (const std::string name : {"light", "cosine", "nothing"}) {
        set_known(settings, name);
        CHECK(settings.known == (name == "nothing" ? Known::nothing : Known::cosine));
        CHECK(settings.light_known == (name == "light"));
        CHECK(known_name(settings) == name);
    }
    CHECK_THROWS_AS(set_known(settings, "all"), std::invalid_argument);
}

TEST_CASE("a picture is rendered by the environment's light or, where that is known, by its averages and its sun") {
    const Scene scene = sphere_scene();
    const EnvironmentMap map = sunny_map();
    const PrefilteredEnvironment averages(map);
    for (const bool known : {false, true}) {
        const PictureSettings settings{small_picture(Method::rotated, 9), known};
        const PixelRules rules(known ? sky_settings(settings, averages) : RenderSettings(settings));
        const Shade shade = known ? reflected_known_light(scene, averages, rules, sun_samples(averages, 9))
                                  : reflected_environment(scene, map, rules);
        CHECK(same(picture(EnvironmentLight(map, known, 1), settings).pixels,
                   render(scene, map, settings, shade).pixels));
    }
}
