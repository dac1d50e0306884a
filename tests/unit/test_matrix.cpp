#include "numerics/matrix.h"

#include "test.h"

TEST_CASE("the row-sum norm is the largest sum of absolute values in a row") {
    Matrix matrix(2, 2);
    matrix(0, 0) = -3;
    matrix(0, 1) = 4;
    matrix(1, 0) = 6;
    CHECK(row_sum_norm(matrix) == 7);
}
