#include "quadrature/covariance.h"

#include "numerics/formatted.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bmc {
using portable::pi;

namespace {

// Smaller moduli count as this one. z is linear in c near the equator, so its error is below 1e-17.
constexpr double smallest_modulus = 0x1p-60;

// The rim integral's trapezoidal rule has an error of about e^(-pi^2 / step): below rounding at 1/4, not at 0.3.
constexpr double rim_step = 0.25;

// cos_theta as the modulus q = c / (1 + sigma) in (0, 1] of the elliptic integrals, sigma the sine.
struct Elevation {
    double sine, modulus;

    explicit Elevation(double cosine)
        : sine(std::sqrt((1 - cosine) * (1 + cosine))), modulus(std::max(cosine / (1 + sine), smallest_modulus)) {}
};

// Bulirsch's complete elliptic integral
//     cel(q, p, a, b) = integral from 0 to pi/2 of (a cos^2 + b sin^2) / ((cos^2 + p sin^2) sqrt(cos^2 + q^2 sin^2)),
// p given by its root (Bulirsch, "Numerical calculation of elliptic integrals and elliptic functions III", Numerische
// Mathematik 1969): 9 steps suffice for every q >= 2^-60, and with a fixed count a loop over many q vectorises.
double cel(double q, double root_p, double a, double b) {
    double e = q, m = 1, p = root_p;
    b /= p;
    for (int step = 0; step < 9; ++step) {
        const double last_a = a, g = e / p;
        a += b / p;
        b = 2 * (b + last_a * g);
        p += g;
        m += q;
        q = 2 * std::sqrt(e);
        e = q * m;
    }
    return pi / 2 * (a * m + b) / (m * (m + p));
}

// The rim integral I below at s = 3/2, where z(c) = 2 pi C - (2^s / s) I has the closed form
//     I = 2 q sqrt(1 + sigma) cel(q, 1 / q^2, 1 / q^2, 1),   q = c / (1 + sigma).
// The factor q has gone into the last two arguments, which stay finite towards the equator.
double elliptic_rim_integral(double cos_theta) {
    const auto [sigma, q] = Elevation(cos_theta);
    return 2 * std::sqrt(1 + sigma) * cel(q, 1 / q, 1 / q, q);
}

// z for the known part cos(theta) at s = 3/2. With A the solution of Legendre's equation of degree 1 that the kernel
// drives,
//     A(t) = (4/15) [sqrt(2) t artanh(sqrt((1 - t) / 2)) - sqrt(1 - t)],
// the divergence theorem and one integration by parts leave a complete elliptic integral over the rim.
double cosine_integral(double cos_theta) {
    const auto [sigma, q] = Elevation(cos_theta);
    return 8 * pi / 3 -
           16 * std::sqrt(2.0) / 15 * std::sqrt(1 + sigma) * (2 * cel(q, 1, 1, q * q) - cel(q, 1 / q, 1, 1));
}

// The nodes y = e^(h k) of the trapezoidal rule in u = ln y, step h, from e^-38 to e^80. Below the first and above the
// last the rim integrand is less than rounding, for every modulus q: its upper end is e^38 / q.
std::vector<double> logarithmic_nodes(double step) {
    std::vector<double> nodes;
    for (int k = 0; k * step <= 38 + 80; ++k) nodes.push_back(portable::exp(k * step - 38));
    return nodes;
}

// The mean of (2 sin^2 t)^(1 + p) over the circle; with tan(t / 2) = e^u it is 2^(1 + p) / pi times the integral of
// sech(u)^(3 + 2p) du. The pole at u = i pi/2 is of an order up to 5, hence half the step of the rim integral.
double mean_sine_power(double p) {
    double sum = 0;
    for (double y : logarithmic_nodes(rim_step / 2)) sum += portable::pow(2 * y / (1 + y * y), 3 + 2 * p);
    return portable::pow(2, 1 + p) / pi * rim_step / 2 * sum;
}

void require_closed_form(bool exists) {
    if (!exists)
        throw std::invalid_argument(
            "a known part goes with the covariance sobolev of smoothness 1.5 only: no other has a closed form for it");
}

// Also of nan, with which no series ends.
void require_cosines(const std::vector<double>& cosines) {
    for (const double each : cosines)
        if (!(each >= 0 && each <= 1))
            throw std::invalid_argument(
                formatted("an elevation cosine must be at %s; it is %.17g", each < 0 ? "least 0" : "most 1", each));
}

}  // namespace

Sobolev::Sobolev(double smoothness) : exponent_(smoothness - 1) {
    if (!(smoothness > 1 && smoothness < 2))
        throw std::invalid_argument(
            formatted("the smoothness must lie between 1 and 2, both excluded; it is %.9g", smoothness));
    constant_ = portable::pow(2, 2 * smoothness - 1) / smoothness;
    if (smoothness != 1.5) nodes_ = logarithmic_nodes(rim_step);
    const double two_p = portable::pow(2, exponent_);
    const double z_pole = 2 * pi * (constant_ - two_p / smoothness);
    integral_of_z_ = 2 * pi * z_pole - 4 * pi * pi * two_p * (mean_sine_power(exponent_) - 1) / smoothness;
}

void Sobolev::evaluate(double* squared_chords, std::size_t count) const {
    if (has_closed_form())
        for (std::size_t i = 0; i < count; ++i) squared_chords[i] = constant_ - std::sqrt(squared_chords[i]);
    else
        for (std::size_t i = 0; i < count; ++i)
            squared_chords[i] = constant_ - portable::pow(squared_chords[i], exponent_);
}

// The divergence theorem turns the hemisphere integral of r^(2p) into one over the rim, and Kepler's substitution of
// the eccentric anomaly E for the azimuth removes its pole: z = 2 pi C - 2^s / s * I with
//     I = integral from 0 to pi of [(1 - 2 sigma cos E + sigma^2) / (1 - sigma cos E)]^p dE.
void Sobolev::integrate(std::vector<double>& cos_thetas, Known known) const {
    require_cosines(cos_thetas);
    if (known != Known::nothing) {
        require_closed_form(has_closed_form());
        for (double& element : cos_thetas) element = cosine_integral(element);
        return;
    }
    const double s = exponent_ + 1, whole = 2 * pi * constant_, factor = portable::pow(2, s) / s;
    if (has_closed_form())
        for (double& element : cos_thetas) element = whole - factor * elliptic_rim_integral(element);
    else
        for (double& element : cos_thetas) element = whole - factor * rim_sum(element);
}

// I for any s. With tan(E / 2) = q y, y = e^u, the integrand is analytic in |Im u| < pi/2 whatever q is, so one step of
// the trapezoidal rule in u suits every elevation.
double Sobolev::rim_sum(double cos_theta) const {
    const auto [sigma, q] = Elevation(cos_theta);
    double sum = 0, base = 0, power = 0;
    for (double y : nodes_) {
        const double yy = y * y, t = q * y, next = (1 + sigma) * (q * q + yy) / (1 + yy);
        if (t > 0x1p55) break;  // what follows is less than rounding
        // The same for half of the nodes, at both ends.
        if (next != base) power = portable::pow(base = next, exponent_);
        sum += power * 2 * t / (1 + t * t);
    }
    return rim_step * sum;
}

double Sobolev::integral_of_z(Known known) const {
    if (known == Known::nothing) return integral_of_z_;
    require_closed_form(has_closed_form());
    return 16.787120248013257721;  // of z cos(theta): quadrature to 20 digits
}

SquaredExponential::SquaredExponential(double length_scale) : kappa_(1 / (length_scale * length_scale)) {
    if (!(length_scale >= 0.05) || !std::isfinite(length_scale))
        throw std::invalid_argument(formatted("the length-scale must be at least 0.05; it is %.9g", length_scale));
    // (1 - e^(-2 kappa)) / kappa = 2 e^-kappa sinh(kappa) / kappa, by the series of sinh: no cancellation.
    double term = portable::exp(-kappa_), sum = term;
    for (int m = 1; m < kappa_ || sum + term != sum; ++m) {
        term *= kappa_ / (2 * m) * (kappa_ / (2 * m + 1));
        sum += term;
    }
    even_part_ = 2 * pi * sum;
}

void SquaredExponential::evaluate(double* squared_chords, std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) squared_chords[i] = portable::exp(-0.5 * kappa_ * squared_chords[i]);
}

// 2 pi times the sum over m of t_m B_m, with t_m the terms of the modified Bessel function I_1 and B_m the integral
// from 0 to c of (1 - u^2)^m du by its recurrence; all positive.
void SquaredExponential::integrate(std::vector<double>& cos_thetas, Known known) const {
    require_closed_form(known == Known::nothing);
    require_cosines(cos_thetas);
    for (double& element : cos_thetas) {
        const double squared_sine = (1 - element) * (1 + element);
        double t = kappa_ / 2 * portable::exp(-kappa_), b = element, edge = element, sum = t * b;
        for (int m = 1; m < kappa_ / 2 || sum + t * b != sum; ++m) {
            t *= kappa_ / (2 * m) * (kappa_ / (2 * m + 2));
            edge *= squared_sine;
            b = (edge + 2 * m * b) / (2 * m + 1);
            sum += t * b;
        }
        element = even_part_ + 2 * pi * sum;
    }
}

double SquaredExponential::integral_of_z(Known known) const {
    require_closed_form(known == Known::nothing);
    double t = kappa_ / 2 * portable::exp(-kappa_), w = 1, sum = t * 0.5;
    for (int m = 1; m < kappa_ / 2 || sum + t != sum; ++m) {
        t *= kappa_ / (2 * m) * (kappa_ / (2 * m + 2));
        w *= 2.0 * m / (2 * m + 1);
        sum += t * (w - 1 / (2.0 * (m + 1)));
    }
    return 2 * pi * (even_part_ + 2 * pi * sum);
}

std::unique_ptr<Covariance> make_covariance(CovarianceFamily family, double parameter) {
    if (family == CovarianceFamily::sobolev) return std::make_unique<Sobolev>(parameter);
    return std::make_unique<SquaredExponential>(parameter);
}
}  // namespace bmc
