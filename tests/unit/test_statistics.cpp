#include "base/statistics.h"
#include "test.h"

TEST_CASE("a large mean leaves the squares around it exact") {
    Statistics statistics;
    for (const double number : {1e9 + 1, 1e9 + 2, 1e9 + 3, 1e9 + 6}) statistics.add(number);
    CHECK(statistics.squares == 4 + 1 + 0 + 9);
}

TEST_CASE("a root mean square's standard error is that of the mean square over 2 RMS") {
    RootMeanSquare rms;
    CHECK(rms.standard_error() == 0);
    for (const double error : {1.0, -5.0, 7.0}) rms.add(error);
    CHECK(rms.value() == 5);
    CHECK(relative(rms.standard_error(), std::sqrt((24 * 24 + 0 + 24 * 24) / 2.0 / 3) / 10) < 1e-15);
}
