#include "quadrature/covariance.h"

#include "base/formatted.h"

#include <algorithm>
#include <stdexcept>

namespace bmc {
using portable::pi;

// Throws for a cosine outside [0, 1], and for nan.
static double squared_sine(double cos_theta) {
    if (!(cos_theta >= 0 && cos_theta <= 1))
        throw std::invalid_argument(formatted("cos(theta) must lie between 0 and 1; it is %.17g", cos_theta));
    return (1 - cos_theta) * (1 + cos_theta);
}

// The polar angle theta with the cosine c, stored as sigma = sin(theta) and q = c / (1 + sigma) = sqrt((1 - sigma) / (1
// + sigma)): 1 straight up, 0 on the horizon. 1 / q must stay finite, so q is at least 2^-60. This changes z by less
// than 1e-17.
struct PolarAngle {
    double sigma, q;

    explicit PolarAngle(double c) : sigma(std::sqrt(squared_sine(c))), q(std::max(c / (1 + sigma), 0x1p-60)) {}
};

// The integral of f(tan^2(E / 2)) over E from 0 to pi; f takes the square so that it needs no root. Substitute
// t = tan(E / 2) = e^v: then dE = 2 t / (1 + t^2) dv = dv / cosh v. The integrand falls like e^-|v|, so outside of
// |v| <= 38 it is below rounding, and inside the trapezoidal rule is exact to rounding: for such smooth functions it
// converges exponentially.
template <class Function>
static double integral_over_angles(double step, Function f) {
    double sum = 0;
    for (double v = -38; v <= 38; v += step) {
        const double t = portable::exp(v);
        sum += 2 * t / (1 + t * t) * f(t * t);
    }
    return step * sum;
}

// z of any covariance: twice the integral of M(b) over E from 0 to pi, where b is the height of a cap, t = tan(E / 2)
// and cos E = (1 - t^2) / (1 + t^2):
//     b = (1 - 2 sigma cos E + sigma^2) / (1 - sigma cos E) = (1 + sigma) (q^4 + t^2) / (q^2 + t^2)
// The appendix of common/README.md derives it, with a figure: great arcs from omega to the horizon cut H into narrow
// sectors of caps around omega, and dE is the area of a sector.
double Covariance::z_by_caps(double cos_theta, double step) const {
    const PolarAngle theta(cos_theta);
    const double q2 = theta.q * theta.q;
    return 2 * integral_over_angles(
                   step, [&](double t2) { return cap_mean((1 + theta.sigma) * (q2 * q2 + t2) / (q2 + t2)); });
}

double Covariance::z(double cos_theta) const { return z_by_caps(cos_theta, 0.25); }

// 4 pi times the integral of b M(b), b = 1 - cos(rho) = 2 t^2 / (1 + t^2), over rho from 0 to pi, t = tan(rho / 2).
// common/README.md derives it.
template <class CapMean>
static double zz_by_caps(CapMean cap_mean) {
    return 4 * pi * integral_over_angles(0.125, [&](double t2) {
               const double b = 2 * t2 / (1 + t2);
               return b * cap_mean(b);
           });
}

double Covariance::zz() const {
    return zz_by_caps([&](double b) { return cap_mean(b); });
}

static double checked(const char* what, double value, double low, double high) {
    if (value >= low && value <= high) return value;
    throw std::invalid_argument(formatted("the %s must lie from %g to %g; it is %.9g", what, low, high, value));
}

GeneralSobolev::GeneralSobolev(double s)
    : exponent(checked("smoothness", s, min_smoothness, max_smoothness) - 1),
      constant(portable::pow(2, 2 * s - 1) / s),
      zz_value(zz_by_caps([&](double b) { return GeneralSobolev::cap_mean(b); })) {}

SquaredExponential::SquaredExponential(double l)
    : kappa(1 / (l * checked("length-scale", l, min_length_scale, max_length_scale))),
      zz_value(zz_by_caps([&](double b) { return SquaredExponential::cap_mean(b); })) {}

std::shared_ptr<const Covariance> make_covariance(CovarianceFamily family, double parameter, Known known) {
    const bool in_closed_form = family == CovarianceFamily::sobolev && parameter == 1.5;
    if (known == Known::cosine && !in_closed_form)
        throw std::invalid_argument(
            "the known part cosine, as of directions of that density, needs the covariance sobolev of smoothness 1.5");
    if (known == Known::cosine) return std::make_shared<SobolevKnownCosine>();
    if (in_closed_form) return std::make_shared<Sobolev>();
    switch (family) {
        case CovarianceFamily::sobolev: return std::make_shared<GeneralSobolev>(parameter);
        case CovarianceFamily::squared_exponential: return std::make_shared<SquaredExponential>(parameter);
    }
    throw std::logic_error("make_covariance has no case for this family");
}

// The rest are closed forms. You need not follow them to use them: a test compares each with 20 digits that were
// computed from its definition, in another way.

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
double Sobolev::z(double cos_theta) const {
    const auto [sigma, q] = PolarAngle(cos_theta);
    return 16 * pi / 3 - 8 * std::sqrt(2.0) / 3 * std::sqrt(1 + sigma) * complete_elliptic(q, 1 / q, 1 / q, q);
}

// With A the solution of Legendre's equation of degree 1 for this k,
//     A(t) = (4/15) [sqrt(2) t artanh(sqrt((1 - t) / 2)) - sqrt(1 - t)],
// the divergence theorem and one integration by parts leave complete elliptic integrals over the horizon.
double SobolevKnownCosine::z(double cos_theta) const {
    const auto [sigma, q] = PolarAngle(cos_theta);
    return 8 * pi / 3 - 16 * std::sqrt(2.0) / 15 * std::sqrt(1 + sigma) *
                            (2 * complete_elliptic(q, 1, 1, q * q) - complete_elliptic(q, 1 / q, 1, 1));
}

// (1 - e^-x) / x. For small x the difference would cancel, so sum the series.
static double exponential_mean(double x) {
    if (x > 1) return (1 - portable::exp(-x)) / x;
    double sum = 1, term = 1;
    for (int m = 2; sum + term != sum; ++m) {
        term *= -x / m;
        sum += term;
    }
    return sum;
}

double SquaredExponential::cap_mean(double b) const { return exponential_mean(kappa * b); }

// A series of positive terms, so that nothing cancels at short length-scales: 2 pi M(2), which is the same for all
// directions, plus 2 pi times the sum over m of t_m B_m. The t_m are e^-kappa times the terms of the modified Bessel
// function I_1(kappa), and B_m, the integral of (1 - u^2)^m over u from 0 to c, has a recurrence.
double SquaredExponential::z(double cos_theta) const {
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
