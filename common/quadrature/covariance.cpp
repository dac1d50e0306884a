#include "quadrature/covariance.h"

#include "base/formatted.h"

#include <stdexcept>

namespace bmc {
using portable::pi;

// z of any covariance: twice the integral of M(b) over E from 0 to pi, where b is the height of a cap, t = tan(E / 2)
// and cos E = (1 - t^2) / (1 + t^2):
//     b = (1 - 2 sigma cos E + sigma^2) / (1 - sigma cos E) = (1 + sigma) (q^4 + t^2) / (q^2 + t^2)
// The appendix of common/README.md derives it, with a figure: great arcs from omega to the horizon cut H into narrow
// sectors of caps around omega, and dE is the area of a sector. The step is in ln t; a length-scale below 1/2 needs a
// smaller one.
double Covariance::z(double cos_theta) const {
    const PolarAngle theta(cos_theta);
    const double q2 = theta.q * theta.q;
    return 2 * integral_over_angles(
                   0.25, [&](double t2) { return cap_mean((1 + theta.sigma) * (q2 * q2 + t2) / (q2 + t2)); });
}

// 4 pi times the integral of b M(b), b = 1 - cos(rho) = 2 t^2 / (1 + t^2), over rho from 0 to pi, t = tan(rho / 2).
// common/README.md derives it.
double Covariance::zz() const {
    return 4 * pi * integral_over_angles(0.125, [&](double t2) {
               const double b = 2 * t2 / (1 + t2);
               return b * cap_mean(b);
           });
}

static double checked(const char* what, double value, double low, double high) {
    if (value >= low && value <= high) return value;
    throw std::invalid_argument(formatted("the %s must lie from %g to %g; it is %.9g", what, low, high, value));
}

GeneralSobolev::GeneralSobolev(double s)
    : exponent(checked("smoothness", s, min_smoothness, max_smoothness) - 1),
      constant(portable::pow(2, 2 * s - 1) / s),
      zz_value(Covariance::zz()) {}

SquaredExponential::SquaredExponential(double l)
    : kappa(1 / (l * checked("length-scale", l, min_length_scale, max_length_scale))), zz_value(Covariance::zz()) {}
}  // namespace bmc
