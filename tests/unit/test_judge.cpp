#include "judge/judge.h"

#include <doctest/doctest.h>

#include <string>

namespace {

int status(const std::string& file, const std::string& integrand, Method method) {
    Judge judge;
    judge.file = file;
    judge.integrand = integrand;
    judge.correct.method = method;
    judge.correct.smoothness = integrand.empty() ? 1.5 : 1.3;
    return judge.report().status;
}

}  // namespace

TEST_CASE("the exit status is 0 for what correct programs make, 1 for what they do not" * doctest::test_suite("long")) {
    const std::string table = "tests/output/references/smoothness.txt", picture = "tests/output/judged.ppm";
    CHECK(status(table, "cosine", Method::pool) == 0);
    CHECK(status(table, "environment", Method::pool) == 1);
    CHECK(status(picture, "", Method::pool) == 0);
    CHECK(status(picture, "", Method::mc) == 1);
    CHECK_THROWS_AS(status("", "", Method::pool), UsageError);
}
