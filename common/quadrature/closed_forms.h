// Integrals over the hemisphere in closed form, to take on trust: tests/unit/test_covariance.cpp compares each with its
// definition and with 20 digits made by other means.
#pragma once

#include "numerics/portable_math.h"

#include <algorithm>

namespace bmc {
// sin(theta)^2. Throws std::invalid_argument for a cosine outside of [0, 1], also for nan, for which no series would
// end.
double squared_sine(double cos_theta);

// The angle theta to the up axis, by its sine sigma and by q = c / (1 + sigma) in (0, 1], c its cosine. Near the
// equator z is linear in c: q = 2^-60 in place of 0 changes it by less than 1e-17.
struct PolarAngle {
    double sigma, q;

    explicit PolarAngle(double c) : sigma(std::sqrt(squared_sine(c))), q(std::max(c / (1 + sigma), 0x1p-60)) {}
};

// The integral of f(tan^2(E / 2)) over E from 0 to pi. With v = ln tan(E / 2), dE = sech(v) dv, equal steps in v crowd
// the nodes at both ends, where f changes quickly near the equator. The trapezoidal rule then errs below rounding, as
// e^-38 is.
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
