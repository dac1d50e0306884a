#include "beyond/request.h"
#include "test.h"

using namespace bmc::beyond;

TEST_CASE("of two known parts the last one counts") {
    Request request;
    Options options;
    request.add_options(options);
    parse({"--known=light", "--known=cosine"}, options);
    CHECK(request.settings.known_part == KnownPart::cosine);
    CHECK(!request.light_known);
}

TEST_CASE("errors in a PFM are as predicted, of each colour") {
    Request request;
    request.settings = small_picture(Method::mc, 5, 16);
    request.show = Show::error;
    request.format = Format::pfm;
    Image errors(1, 1);
    const std::string note = stderr_of([&] { errors = request.image(coloured_map(32, 17)); });
    CHECK(std::any_of(errors.pixels.begin(), errors.pixels.end(), [](Colour each) { return each.x != each.y; }));
    CHECK(note == Containing{formatted("the predicted RMSE is %.2g\n", root_mean_square(errors))});
}
