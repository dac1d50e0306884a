#include "beyond/request.h"
#include "test.h"

using namespace bmc::beyond;

// The file of a picture of 16 x 16 pixels, after what is printed.
static std::string asked(const EnvironmentMap& map, std::vector<std::string> words) {
    Request request;
    words.insert(words.end(), {"--size=16", "--format=pfm", "--samples=10"});
    parse(words, request.options());
    std::string file;
    const std::string printed = stderr_of([&] { file = request.file(request.image(map)); });
    return printed.substr(printed.empty() ? 0 : printed.find(": ") + 2) + file;  // without the program's name
}

TEST_CASE("a request is a picture, its predicted errors, or the samples that an RMSE takes") {
    const EnvironmentMap map = coloured_map(32, 17);
    for (const std::string known : {"nothing", "cosine", "light"}) {
        CAPTURE(known);
        RenderSettings settings = small_picture(Method::pool, 10, 16);
        settings.pool = 20;
        settings.known = known == "nothing" ? Known::nothing : Known::cosine;
        const EnvironmentLight light(map, known == "light", 1);
        const Scene scene = sphere_scene();
        const Image image = picture(light, settings),
                    errors =
                        predicted_errors(image, render(scene, map, settings, better_shader(scene, light, settings)));
        const std::string note = "%zu samples for a predicted RMSE of %.2g\n";
        CHECK(asked(map, {"--known=" + known}) == encode(image, Format::pfm));
        CHECK(asked(map, {"--known=" + known, "--show=error"}) ==
              formatted(note.c_str(), std::size_t{10}, root_mean_square(errors)) + encode(errors, Format::pfm));
        const Prediction chosen = samples_for(1, 4096, light, settings);
        settings.samples = static_cast<std::size_t>(chosen.samples);
        CHECK(asked(map, {"--known=" + known, "--rmse=1"}) ==
              formatted(note.c_str(), settings.samples, chosen.rmse) + encode(picture(light, settings), Format::pfm));
    }
    CHECK(asked(map, {"--known=light", "--known=cosine"}) == asked(map, {"--known=cosine"}));  // the last one counts
    CHECK_THROWS_WITH(parse({"--known=all"}, Request().options()), "--known: 'all' is not nothing, cosine or light");
}

TEST_CASE("what is shown, and what is known, has names") {
    CHECK(names_all<Show>(show_names));
    CHECK(names_all<KnownFactor>(known_factor_names));
}

TEST_CASE("errors in a PPM are grey, white at twice their root mean square") {
    Request request;
    request.settings = small_picture(Method::mc, 5, 16);
    request.show = Show::error;
    Image grey(1, 1);
    stderr_of([&] { grey = request.image(coloured_map(32, 17)); });
    CHECK(relative(root_mean_square(grey), 0.5) < 1e-14);
    for (const Color& pixel : grey.pixels) CHECK(pixel == pixel.x * Color{1, 1, 1});
}

TEST_CASE("an RMSE that takes too many samples is refused, and the light that is known cures it") {
    const EnvironmentMap map = sunny_map();
    CHECK(message_of([&] { asked(map, {"--rmse=0.1", "--method=mc"}); }) == Containing{"take --known light"});
    CHECK_NOTHROW(asked(map, {"--rmse=0.1", "--method=mc", "--known=light"}));
}

TEST_CASE("weights give no warning where the light is known") {
    const EnvironmentMap map = coloured_map(32, 17);
    CHECK(asked(map, {"--noise=100"}) == Containing{"a white world"});
    CHECK(!contains(asked(map, {"--noise=100", "--known=light"}), "a white world"));
}
