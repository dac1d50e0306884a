#include "quadrature/covariance.h"

#include "numerics/formatted.h"

#include <algorithm>
#include <stdexcept>

namespace bmc {
using portable::pi;

namespace {

// The angle theta to the up axis, by its sine sigma and by q = c / (1 + sigma) in (0, 1], c its cosine. Near the
// equator z is linear in c: q = 2^-60 in place of 0 changes it by less than 1e-17.
struct PolarAngle {
    double sigma, q;

    explicit PolarAngle(double c) : sigma(std::sqrt((1 - c) * (1 + c))), q(std::max(c / (1 + sigma), 0x1p-60)) {}
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

// Bulirsch's complete elliptic integral, the integral over t from 0 to pi/2 of
//     (a cos^2 t + b sin^2 t) / ((cos^2 t + p sin^2 t) sqrt(cos^2 t + q^2 sin^2 t)),
// where root_p = sqrt(p) ("Numerical calculation of elliptic integrals and elliptic functions III", Numerische
// Mathematik 1969). It is an arithmetic-geometric mean: each step doubles the number of digits in which m and q agree.
double complete_elliptic(double q, double root_p, double a, double b) {
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

// z of Sobolev 3/2. Its M(b) is 8/3 - (2/3) sqrt(2 b), so z_by_caps is 16 pi / 3 less (4/3) sqrt(2) times the integral
// of sqrt(b) over E, which is 2 q sqrt(1 + sigma) cel(q, 1 / q^2, 1 / q^2, 1). Here the factor q has gone into the last
// two arguments: they stay finite towards the equator.
double sobolev_z(double cos_theta) {
    const auto [sigma, q] = PolarAngle(cos_theta);
    return 16 * pi / 3 - 8 * std::sqrt(2.0) / 3 * std::sqrt(1 + sigma) * complete_elliptic(q, 1 / q, 1 / q, q);
}

// z of Sobolev 3/2 for the known part cos(theta). With A the solution of Legendre's equation of degree 1 for this k,
//     A(t) = (4/15) [sqrt(2) t artanh(sqrt((1 - t) / 2)) - sqrt(1 - t)],
// the divergence theorem and one integration by parts leave complete elliptic integrals over the rim.
double sobolev_cosine_z(double cos_theta) {
    const auto [sigma, q] = PolarAngle(cos_theta);
    return 8 * pi / 3 - 16 * std::sqrt(2.0) / 15 * std::sqrt(1 + sigma) *
                            (2 * complete_elliptic(q, 1, 1, q * q) - complete_elliptic(q, 1 / q, 1, 1));
}
constexpr double sobolev_cosine_zz = 16.787120248013257721;  // by quadrature to 20 digits

// (1 - e^-x) / x, for small x by its series, where the difference would cancel.
double exponential_mean(double x) {
    if (x > 1) return (1 - portable::exp(-x)) / x;
    double sum = 1, term = 1;
    for (int m = 2; sum + term != sum; ++m) {
        term *= -x / m;
        sum += term;
    }
    return sum;
}

void require_closed_form(bool exists) {
    if (!exists)
        throw std::invalid_argument("only sobolev of smoothness 1.5 has a closed form for the known part cosine");
}

}  // namespace

Covariance::Covariance(CovarianceFamily family, double parameter)
    : family_(family),
      parameter_(parameter),
      exponent_(parameter - 1),
      constant_(portable::pow(2, 2 * parameter - 1) / parameter),
      kappa_(1 / (parameter * parameter)),
      has_closed_form_(family == CovarianceFamily::sobolev && parameter == 1.5) {
    const bool sobolev = family == CovarianceFamily::sobolev;
    if (sobolev && !(parameter > 1 && parameter < 2))
        throw std::invalid_argument(formatted("the smoothness must lie between 1 and 2; it is %.9g", parameter));
    if (!sobolev && !(parameter >= 0.05 && parameter <= DBL_MAX))
        throw std::invalid_argument(formatted("the length-scale must be at least 0.05; it is %.9g", parameter));
    // 4 pi times the integral of b M(b), b = 1 - cos(rho), over rho from 0 to pi: common/README.md derives it.
    zz_ = 4 * pi * integral_over_angles(0.125, [&](double tt) {
              const double b = 2 * tt / (1 + tt);
              return b * cap_mean(b);
          });
}

// M(b): the mean of k(w, .) over the cap around w of height b = 1 - cos(radius). Equal heights have equal areas, and
// the chord at depth h is sqrt(2 h). So M(b) is 1 / b times the integral of k(sqrt(2 h)) over h from 0 to b.
double Covariance::cap_mean(double height) const {
    switch (family_) {
        case CovarianceFamily::sobolev: return constant_ - portable::pow(2 * height, exponent_) / (exponent_ + 1);
        case CovarianceFamily::squared_exponential: return exponential_mean(kappa_ * height);
    }
    return 0;
}

// z of any covariance: twice the integral of M(b) over E from 0 to pi, where b is the height of a cap,
//     b = (1 - 2 sigma cos E + sigma^2) / (1 - sigma cos E) = (1 + sigma) (q^4 + t^2) / (q^2 + t^2),  t = tan(E / 2).
// common/README.md derives it, with a figure: great arcs from w to the rim cut H into narrow sectors of caps around w,
// and E is Kepler's eccentric anomaly of their azimuth. A length-scale below 1/2 needs a smaller step than 1/4.
double Covariance::z_by_caps(double cos_theta) const {
    const PolarAngle theta(cos_theta);
    const double qq = theta.q * theta.q;
    return 2 * integral_over_angles(
                   0.25, [&](double tt) { return cap_mean((1 + theta.sigma) * (qq * qq + tt) / (qq + tt)); });
}

// The same by a series of positive terms, which is faster and surer for short length-scales: 2 pi M(2), the same for
// all directions, and 2 pi times the sum over m of t_m B_m. The t_m are the terms of the modified Bessel function I_1,
// and B_m, the integral of (1 - u^2)^m over u from 0 to c, has a recurrence.
double Covariance::squared_exponential_z(double cos_theta) const {
    const double squared_sine = (1 - cos_theta) * (1 + cos_theta);
    double t = kappa_ / 2 * portable::exp(-kappa_), b = cos_theta, edge = cos_theta, sum = t * b;
    for (int m = 1; m < kappa_ / 2 || sum + t * b != sum; ++m) {
        t *= kappa_ / (2 * m) * (kappa_ / (2 * m + 2));
        edge *= squared_sine;
        b = (edge + 2 * m * b) / (2 * m + 1);
        sum += t * b;
    }
    return 2 * pi * (cap_mean(2) + sum);
}

double Covariance::z(double cos_theta, Known known) const {
    if (!(cos_theta >= 0 && cos_theta <= 1))  // also of nan, for which no series would end
        throw std::invalid_argument(formatted("cos(theta) must lie between 0 and 1; it is %.17g", cos_theta));
    if (known == Known::cosine) {
        require_closed_form(has_closed_form_);
        return sobolev_cosine_z(cos_theta);
    }
    if (has_closed_form_) return sobolev_z(cos_theta);
    return family_ == CovarianceFamily::squared_exponential ? squared_exponential_z(cos_theta) : z_by_caps(cos_theta);
}

double Covariance::zz(Known known) const {
    if (known == Known::nothing) return zz_;
    require_closed_form(has_closed_form_);
    return sobolev_cosine_zz;
}
}  // namespace bmc
