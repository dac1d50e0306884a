#include "beyond/reports/root_mean_square.h"
#include "test.h"

TEST_CASE("the root mean square, and its standard error by that of the mean square over 2 RMS") {
    RootMeanSquare rms;
    CHECK(rms.standard_error() == 0);
    for (const double error : {1.0, -5.0, 7.0}) rms.add(error);
    CHECK(rms.value() == 5);
    CHECK(relative(rms.standard_error(), std::sqrt((24 * 24 + 0 + 24 * 24) / 2.0 / 3) / 10) < 1e-15);
}
