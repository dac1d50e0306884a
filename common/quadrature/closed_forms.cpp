#include "quadrature/closed_forms.h"

#include "base/formatted.h"

#include <stdexcept>

// Nobody has to follow these formulas to use them: a test compares each with its definition, to 20 digits.
namespace bmc {
using portable::pi;

double squared_sine(double cos_theta) {
    if (!(cos_theta >= 0 && cos_theta <= 1))
        throw std::invalid_argument(formatted("cos(theta) must lie between 0 and 1; it is %.17g", cos_theta));
    return (1 - cos_theta) * (1 + cos_theta);
}

// Bulirsch's complete elliptic integral, the integral over t from 0 to pi/2 of
//     (a cos^2 t + b sin^2 t) / ((cos^2 t + p sin^2 t) sqrt(cos^2 t + q^2 sin^2 t)),
// where root_p = sqrt(p) ("Numerical calculation of elliptic integrals and elliptic functions III", Numerische
// Mathematik 1969). It is an arithmetic-geometric mean: each step doubles the number of digits in which m and q agree.
static double complete_elliptic(double q, double root_p, double a, double b) {
    double e = q, m = 1, p = root_p;
    b /= p;
    while (true) {
        const double last_a = a, last_m = m, g = e / p;
        a += b / p;
        b = 2 * (b + last_a * g);
        p += g;
        m += q;
        if (std::fabs(last_m - q) <= 1e-8 * last_m) return pi / 2 * (a * m + b) / (m * (m + p));
        q = 2 * std::sqrt(e);
        e = q * m;
    }
}

// M(b) is 8/3 - (2/3) sqrt(2 b), so z by caps is 16 pi / 3 minus (4/3) sqrt(2) times the integral of sqrt(b) over E,
// which is 2 q sqrt(1 + sigma) cel(q, 1 / q^2, 1 / q^2, 1), as tan(E / 2) = q cot t shows. cel is linear in its last
// two arguments: with the factor q moved into them nothing is 0 times infinity.
double sobolev_z(double cos_theta) {
    const auto [sigma, q] = PolarAngle(cos_theta);
    return 16 * pi / 3 - 8 * std::sqrt(2.0) / 3 * std::sqrt(1 + sigma) * complete_elliptic(q, 1 / q, 1 / q, q);
}

// With A the solution of Legendre's equation of degree 1 for this k,
//     A(t) = (4/15) [sqrt(2) t artanh(sqrt((1 - t) / 2)) - sqrt(1 - t)],
// the divergence theorem and one integration by parts leave complete elliptic integrals over the horizon.
double sobolev_cosine_z(double cos_theta) {
    const auto [sigma, q] = PolarAngle(cos_theta);
    return 8 * pi / 3 - 16 * std::sqrt(2.0) / 15 * std::sqrt(1 + sigma) *
                            (2 * complete_elliptic(q, 1, 1, q * q) - complete_elliptic(q, 1 / q, 1, 1));
}

// For small x the difference would cancel, so sum the series.
double exponential_mean(double x) {
    if (x > 1) return (1 - portable::exp(-x)) / x;
    double sum = 1, term = 1;
    for (int m = 2; sum + term != sum; ++m) {
        term *= -x / m;
        sum += term;
    }
    return sum;
}

// A series of positive terms, so that nothing cancels at short length-scales: 2 pi M(2), which is the same for all
// directions, plus 2 pi times the sum over m of t_m B_m. The t_m are e^-kappa times the terms of the modified Bessel
// function I_1(kappa), and B_m, the integral of (1 - u^2)^m over u from 0 to c, has a recurrence.
double squared_exponential_z(double cos_theta, double kappa) {
    const double ss = squared_sine(cos_theta);
    double t = kappa / 2 * portable::exp(-kappa), b = cos_theta, edge = cos_theta, sum = t * b;
    for (int m = 1; m < kappa / 2 || sum + t * b != sum; ++m) {
        t *= kappa / (2 * m) * (kappa / (2 * m + 2));
        edge *= ss;
        b = (edge + 2 * m * b) / (2 * m + 1);
        sum += t * b;
    }
    return 2 * pi * (exponential_mean(2 * kappa) + sum);
}
}  // namespace bmc
