#include "base/statistics.h"
#include "test.h"

TEST_CASE("the mean, the squares around it and its standard error are by the definition") {
    Statistics statistics;
    for (const double number : {1e9 + 1, 1e9 + 2, 1e9 + 3, 1e9 + 6}) {
        statistics.add(number);
        if (statistics.count < 2) CHECK(std::isnan(statistics.standard_error()));
    }
    CHECK(statistics.count == 4);
    CHECK(statistics.mean == 1e9 + 3);
    CHECK(statistics.squares == 4 + 1 + 0 + 9);
    CHECK(relative(statistics.standard_error(), std::sqrt(14.0 / 3 / 4)) < 1e-15);
}

TEST_CASE("a root mean square's standard error is that of the mean square over 2 RMS") {
    RootMeanSquare rms;
    CHECK(rms.standard_error() == 0);
    for (const double error : {1.0, -5.0, 7.0}) rms.add(error);
    CHECK(rms.value() == 5);
    CHECK(relative(rms.standard_error(), std::sqrt((24 * 24 + 0 + 24 * 24) / 2.0 / 3) / 10) < 1e-15);
}
