#include "judge/judge.h"

#include <doctest/doctest.h>

#include <string>

namespace {

int status(const std::string& file, Method method) {
    Judge judge;
    judge.file = file;
    judge.correct.method = method;
    return judge.report().status;
}

}  // namespace

TEST_CASE("the exit status is 0 for what correct programs make, 1 for what they do not" * doctest::test_suite("long")) {
    const std::string picture = "tests/output/judged.ppm";
    CHECK(status(picture, Method::pool) == 0);
    CHECK(status(picture, Method::mc) == 1);
    CHECK_THROWS_AS(status("", Method::pool), UsageError);
}
