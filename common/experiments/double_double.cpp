#include "experiments/double_double.h"

#include <cmath>

namespace {

const DoubleDouble ln2{0x1.62e42fefa39efp-1, 0x1.abc9e3b39803fp-56};

}  // namespace

// Long division, three digits of a double each.
DoubleDouble operator/(DoubleDouble a, DoubleDouble b) {
    const double first = a.high / b.high;
    const DoubleDouble rest = a - b * first;
    const double second = rest.high / b.high, third = (rest - b * second).high / b.high;
    return exact_sum(first, second) + third;
}

// A step of Newton's iteration from the root of the high part doubles its digits.
DoubleDouble sqrt(DoubleDouble x) {
    if (x.high == 0) return 0;
    const double root = std::sqrt(x.high);
    return exact_sum(root, (x - exact_product(root, root)).high / (2 * root));
}

// e^x = 2^k (e^(r / 256))^256 with |r| <= ln(2) / 2, by Taylor's series, whose 11th term is below 2^-130.
DoubleDouble exp(DoubleDouble x) {
    const double k = std::floor(x.high / ln2.high + 0.5);
    const DoubleDouble r = (x - ln2 * k) * 0x1p-8;
    DoubleDouble sum = 1;
    for (int n = 11; n >= 1; --n) sum = sum * r / n + 1;
    for (int squaring = 0; squaring < 8; ++squaring) sum = sum * sum;
    for (double n = std::fabs(k); n > 0; --n) sum = sum * (k > 0 ? 2.0 : 0.5);
    return sum;
}

// A step of Newton's iteration for e^y = x from the logarithm of the high part.
DoubleDouble log(DoubleDouble x) {
    const DoubleDouble y = portable::log(x.high);
    return y + (x * exp(-y) - 1);
}

DoubleDouble pow(DoubleDouble x, DoubleDouble y) { return x.high == 0 ? DoubleDouble(0) : exp(y * log(x)); }
