// Integrals over the hemisphere in closed form, which you may believe at a first reading:
// tests/unit/test_covariance.cpp compares each with 20 digits that were computed from its definition, in another way.
#pragma once

#include "base/portable_math.h"

#include <algorithm>

namespace bmc {
// sin(theta)^2. Throws std::invalid_argument for a cosine outside [0, 1], and for nan.
double squared_sine(double cos_theta);

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
double integral_over_angles(double step, Function f) {
    double sum = 0;
    for (double v = -38; v <= 38; v += step) {
        const double t = portable::exp(v);
        sum += 2 * t / (1 + t * t) * f(t * t);
    }
    return step * sum;
}

// Sobolev 3/2: z and zz, with p = 1 and with p = cos(theta).
double sobolev_z(double cos_theta);
double sobolev_cosine_z(double cos_theta);
constexpr double sobolev_zz = 32 * portable::pi * portable::pi / 3 - 128 * portable::pi / 9;
constexpr double sobolev_cosine_zz = 16.787120248013257721;  // by quadrature to 20 digits

// The squared exponential, kappa = 1 / length-scale^2: z, and its mean over a cap, (1 - e^-x) / x with x = kappa b.
double squared_exponential_z(double cos_theta, double kappa);
double exponential_mean(double x);
}  // namespace bmc
