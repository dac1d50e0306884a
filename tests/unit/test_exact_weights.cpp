#include "experiments/exact_weights.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

namespace {

// Both parts, to a few units of 2^-104.
bool equal(DoubleDouble x, double high, double low) {
    return std::fabs((x - DoubleDouble(high, low)).high) <= std::fabs(high) * 0x1p-100;
}

}  // namespace

TEST_CASE("sums, products, quotients and roots have 30 digits") {
    const DoubleDouble third = DoubleDouble(1) / 3;
    CHECK(equal(third * 3, 1, 0));
    CHECK(equal(third + third + third, 1, 0));
    CHECK(equal(third, 0x1.5555555555555p-2, 0x1.5555555555555p-56));
    CHECK(equal(DoubleDouble(1) + 0x1p-80 - 1, 0x1p-80, 0));
    const DoubleDouble root = sqrt(DoubleDouble(2));
    CHECK(equal(root * root, 2, 0));
    CHECK(sqrt(DoubleDouble(0)).high == 0);
}

// e, ln 10 and 2^0.75 to 32 digits, from tables.
TEST_CASE("exponential, logarithm and power have 29 digits") {
    CHECK(equal(exp(DoubleDouble(1)), 2.718281828459045091, 1.4456468917292501578e-16));
    CHECK(equal(log(DoubleDouble(10)), 2.3025850929940459011, -2.1707562233822493507e-16));
    const DoubleDouble power = pow(DoubleDouble(2), 0.75), squared = power * power;
    CHECK(equal(squared * squared, 8, 0));
    for (const double x : {-300.0, -1.5, 1e-10, 0.3, 40.0})
        CHECK(std::fabs((log(exp(DoubleDouble(x))) - x).high) < 1e-26);
    CHECK(pow(DoubleDouble(0), 0.5).high == 0);
}
