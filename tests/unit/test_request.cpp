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

TEST_CASE("of two known factors the last one counts") {
    const EnvironmentMap map = coloured_map(32, 17);
    CHECK(asked(map, {"--known=light", "--known=cosine"}) == asked(map, {"--known=cosine"}));
    CHECK_THROWS_WITH(parse({"--known=all"}, Request().options()), "--known: 'all' is not nothing, cosine or light");
}

TEST_CASE("errors in a PFM are as predicted, in a PPM grey, white at twice their root mean square") {
    Request request;
    request.settings = small_picture(Method::mc, 5, 16);
    request.show = Show::error;
    request.format = Format::pfm;
    Image errors(1, 1), grey(1, 1);
    const std::string note = stderr_of([&] { errors = request.image(coloured_map(32, 17)); });
    CHECK(note == Containing{formatted("5 samples for a predicted RMSE of %.2g\n", root_mean_square(errors))});
    request.format = Format::ppm;
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
