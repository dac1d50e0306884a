// Covariance functions on the sphere, and their integrals over the hemisphere H. A covariance k depends on two
// directions only by their squared chord r^2 = |omega - omega'|^2 = 2 - 2 omega.omega' (a difference that rounding can
// leave below 0, where its root is nan), so rotating all directions about the up axis changes neither Q nor z. Bayesian
// quadrature needs two of its integrals (O'Hagan, "Bayes-Hermite quadrature", J. Stat. Plan. Inf. 1991):
//     z(omega) = integral over H of k(omega, omega') p(omega') d omega',
//     zz = integral over H of z(omega) p(omega) d omega,
// where f p is the integrand: the Gaussian process models f. p is the known part, 1, or cos(theta) if that is known.
#pragma once

#include "quadrature/hemisphere.h"

#include <memory>

namespace bmc {
// What is known of an integrand, p(direction), and the integral of p over H.
enum class Known { nothing, cosine };
inline constexpr const char* known_names[] = {"nothing", "cosine"};
inline double known_part(Known known, Vec3 direction) { return known == Known::cosine ? direction.y : 1; }
inline double known_integral(Known known) { return known == Known::cosine ? portable::pi : 2 * portable::pi; }

// The p that directions of this density are in proportion to.
inline Known known_of(Density density) { return density == Density::cosine ? Known::cosine : Known::nothing; }

// A covariance has to define only k and M.
struct Covariance {
    const Known known;  // the p of z and zz

    explicit Covariance(Known p = Known::nothing) : known(p) {}
    virtual ~Covariance() = default;

    // k of a squared chord, in [0, 4].
    virtual double k(double squared_chord) const = 0;

    // M(b): the mean of k(omega, .) over the cap around omega of height b = 1 - cos(radius). Slices of equal height
    // have equal areas, and the chord at depth h is sqrt(2 h). So M(b) is 1 / b times the integral of k(sqrt(2 h)) over
    // h from 0 to b.
    virtual double cap_mean(double b) const = 0;

    // z of a direction with this cos(theta), and zz. By default p is 1, and both are integrals of M. z throws
    // std::invalid_argument for a cosine outside of [0, 1].
    virtual double z(double cos_theta) const;
    virtual double zz() const;

    // z for p = 1 as an integral of M, with this step of ln t. Exact to rounding by 1/4 for Sobolev, and by 1/8 for a
    // squared exponential, too, which 1/4 leaves 1e-10 off at l = 0.05.
    double z_by_caps(double cos_theta, double step) const;
};

// Sobolev of smoothness 3/2: k(r) = 8/3 - r falls on a straight line from 8/3 to 2/3. Its functions are continuous but
// rough. Light has edges, which no continuous prior has; a rough one is less wrong than a smooth one.
struct Sobolev : Covariance {
    using Covariance::Covariance;
    double k(double squared_chord) const override { return 8.0 / 3 - std::sqrt(squared_chord); }
    double cap_mean(double b) const override { return 8.0 / 3 - 2.0 / 3 * std::sqrt(2 * b); }
    double z(double cos_theta) const override;
    double zz() const override { return 32 * portable::pi * portable::pi / 3 - 128 * portable::pi / 9; }
};

// The same with the known part p = cos(theta), for directions that are denser where the cosine is large.
struct SobolevKnownCosine final : Sobolev {
    SobolevKnownCosine() : Sobolev(Known::cosine) {}
    double z(double cos_theta) const override;
    double zz() const override { return 16.787120248013257721; }  // by quadrature to 20 digits
};

// Sobolev of any smoothness s between 1 and 2: k(r) = C - r^(2s - 2), C = 2^(2s - 1) / s (Brauchart, Saff, Sloan &
// Womersley, "QMC designs", Mathematics of Computation 83, 2014). The sheet's base code has s = 1.4 (Marques, Bouville
// & Bouatouch, "Optimal sample weights for hemispherical integral quadratures", Computer Graphics Forum 38(1), 2019).
inline constexpr double min_smoothness = 1.001, max_smoothness = 1.999;
struct GeneralSobolev final : Covariance {
    const double exponent, constant, zz_value;  // s - 1, C, and zz, computed once

    explicit GeneralSobolev(double smoothness);  // throws std::invalid_argument for one outside of this range

    double k(double squared_chord) const override { return constant - portable::pow(squared_chord, exponent); }
    double cap_mean(double b) const override { return constant - portable::pow(2 * b, exponent) / (exponent + 1); }
    double zz() const override { return zz_value; }
};

// k(r) = exp(-r^2 / 2 l^2) of length-scale l. Its functions have all derivatives. For l below 0.05, e^(-1 / l^2) comes
// close to underflow; for l above 1e6, k is 1 for all directions.
inline constexpr double min_length_scale = 0.05, max_length_scale = 1e6;
struct SquaredExponential final : Covariance {
    const double kappa, zz_value;  // 1 / l^2, and zz, computed once

    explicit SquaredExponential(double length_scale);  // throws std::invalid_argument for one outside of this range

    double k(double squared_chord) const override { return portable::exp(-0.5 * kappa * squared_chord); }
    double cap_mean(double b) const override;
    double z(double cos_theta) const override;
    double zz() const override { return zz_value; }
};

// Add a covariance here and to the table; the compiler then asks for its case in make_covariance.
enum class CovarianceFamily { sobolev, squared_exponential };
inline constexpr const char* covariance_names[] = {"sobolev", "squared-exponential"};

// The covariance of this family and parameter, the smoothness of sobolev or else the length-scale. Throws
// std::invalid_argument as its constructor does, and if its z has no closed form where the cosine is known.
std::shared_ptr<const Covariance> make_covariance(CovarianceFamily family, double parameter,
                                                  Known known = Known::nothing);
}  // namespace bmc
