#include "experiments/statistics.h"
#include "test.h"

TEST_CASE("the mean, the squares around it and its standard error are those of the definition") {
    Statistics statistics;
    for (const double number : {1e9 + 1, 1e9 + 2, 1e9 + 3, 1e9 + 6}) {
        statistics.add(number);
        if (statistics.count < 2) CHECK(std::isnan(statistics.standard_error()));
    }
    CHECK((statistics.count == 4 && statistics.mean == 1e9 + 3 && statistics.squares == 4 + 1 + 0 + 9));
    CHECK(relative(statistics.standard_error(), std::sqrt(14.0 / 3 / 4)) < 1e-15);
}
