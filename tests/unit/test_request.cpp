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
        PictureSettings settings{small_picture(Method::pool, 10, 16), false};
        settings.pool = 20;
        settings.light_known = known == "light";
        settings.known = known == "nothing" ? Known::nothing : Known::cosine;
        const EnvironmentLight light(map, settings.light_known, 1);
        const Image image = picture(light, settings),
                    errors = standard_errors(image, picture(light, with_next_seed(settings)));
        const std::string told = "%zu samples for a predicted RMSE of %.2g\n";
        CHECK(asked(map, {"--known=" + known}) == encode(image, Format::pfm));
        CHECK(asked(map, {"--known=" + known, "--show=error"}) ==
              formatted(told.c_str(), std::size_t{10}, root_mean_square(errors)) + encode(errors, Format::pfm));
        const ChosenSamples chosen = samples_for(1, 4096, light, settings);
        settings.samples = chosen.samples;
        CHECK(asked(map, {"--known=" + known, "--rmse=1"}) ==
              formatted(told.c_str(), chosen.samples, chosen.rmse) + encode(picture(light, settings), Format::pfm));
    }
    CHECK(asked(map, {"--known=light", "--known=cosine"}) == asked(map, {"--known=cosine"}));  // the last one counts
    CHECK_THROWS_WITH(parse({"--known=all"}, Request().options()), "--known: 'all' is not nothing, cosine or light");
    CHECK(asked(map, {"--show=error", "--method=single"}) == Containing{"; all pixels share one rule"});
}

TEST_CASE("what is shown, and what is known, has names") {
    CHECK(names_all(show_names));
    CHECK(names_all(known_factor_names));
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

TEST_CASE("an RMSE under a sun is refused unless the light is known") {
    const EnvironmentMap map = sunny_map();
    CHECK(message_of([&] { asked(map, {"--rmse=1"}); }) ==
          Containing{formatted("the sun, which sends %.3g %% of the light", 100 * Sun(map).share())});
    CHECK_NOTHROW(asked(map, {"--rmse=1", "--known=light"}));
    CHECK(asked(map, {"--show=error"}) == Containing{"it may miss the sun"});
    CHECK(!contains(asked(map, {"--show=error", "--known=light"}), "sun"));
}
