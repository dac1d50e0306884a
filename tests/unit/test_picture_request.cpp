#include "scene/picture_request.h"
#include "test.h"

TEST_CASE("the options of a picture set its members, in the ranges of a picture and of a process") {
    PictureRequest request;
    const RenderSettings& s = request.settings;
    for (const std::string word :
         {"--size=8192", "--size=5x6", "--samples=4096", "--pool=1000", "--threads=256", "--exposure=200",
          "--exposure=-200", "--smoothness=1.001", "--smoothness=1.999", "--length-scale=0.05", "--length-scale=1e6",
          "--noise=0", "--noise=1000", "--seed=0", "--seed=18446744073709551615"})
        CHECK_MESSAGE(message_of([&] { parse({word}, request); }) == "", word);
    for (const std::string word :
         {"--size=8193", "--size=5x", "--size=x5", "--size=5x5x5", "--size=0", "--size=5x8193", "--samples=4097",
          "--pool=1001", "--threads=257", "--exposure=200.1", "--exposure=-200.1", "--smoothness=1.0005",
          "--smoothness=1.9995", "--length-scale=0.0499", "--length-scale=1.1e6", "--noise=-1e-9", "--noise=1001",
          "--seed=-1"})
        CHECK_THROWS_AS_MESSAGE(parse({word}, request), std::invalid_argument, word);
    CHECK(Numbers{s.width + 0.0, s.height + 0.0} == Numbers{5, 6});
    parse({"--size=7"}, request);
    CHECK(Numbers{s.width + 0.0, s.height + 0.0} == Numbers{7, 7});
}

TEST_CASE("the known part is the density of the placement, unless it is given, before or after") {
    const auto known_part_of = [](const std::vector<std::string>& words) {
        PictureRequest request;
        parse(words, request);
        return request.settings.make_covariance()->known_part();
    };
    CHECK(known_part_of({}) == KnownPart::nothing);
    CHECK(known_part_of({"--placement=cosine-stratified"}) == KnownPart::cosine);
    CHECK(known_part_of({"--placement=cosine", "--known=nothing"}) == KnownPart::nothing);
    CHECK(known_part_of({"--known=nothing", "--placement=cosine-fibonacci"}) == KnownPart::nothing);
    CHECK(known_part_of({"--known=cosine", "--placement=fibonacci"}) == KnownPart::cosine);
}
