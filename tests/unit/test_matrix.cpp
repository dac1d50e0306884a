#include "numerics/matrix.h"

#include "test.h"

TEST_CASE("a matrix starts at zero and is stored row by row") {
    Matrix matrix(2, 3);
    CHECK(matrix.rows() == 2);
    CHECK(matrix.columns() == 3);
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            CHECK(matrix(i, j) == 0);
            matrix(i, j) = static_cast<double>(10 * i + j);
        }
    CHECK(matrix.row(1)[2] == 12);
    CHECK(&matrix(1, 0) == matrix.row(0) + 3);
}

TEST_CASE("the row-sum norm is the largest sum of absolute values in a row") {
    Matrix matrix(2, 2);
    matrix(0, 0) = -3;
    matrix(0, 1) = 4;
    matrix(1, 0) = 6;
    CHECK(row_sum_norm(matrix) == 7);
}
