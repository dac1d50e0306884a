#include "scene/picture_request.h"
#include "test.h"

TEST_CASE("the options of a picture set its members, in the ranges of a picture") {
    PictureRequest request;
    const RenderSettings& s = request.settings;
    check_ranges(request.options(),
                 {"--size=8192", "--size=5x6", "--samples=1000000", "--pool=1000", "--threads=256", "--exposure=200",
                  "--exposure=-200", "--method=rotated", "--environment=a.hdr", "--format=pfm", "--noise=0.5"},
                 {"--size=8193", "--size=5x", "--size=x5", "--size=5x5x5", "--size=0", "--size=5x8193",
                  "--samples=1000001", "--pool=1001", "--threads=257", "--exposure=200.1", "--exposure=-200.1"});
    CHECK(Numbers{s.width + 0.0, s.height + 0.0} == Numbers{5, 6});
    parse({"--size=7"}, request.options());
    CHECK(Numbers{s.width + 0.0, s.height + 0.0} == Numbers{7, 7});
}
