// Covariance functions on the sphere, and their integrals over the hemisphere H. A covariance k sees two directions
// through the squared chord r^2 = |w - w'|^2 = 2 - 2 w.w' alone, so turning all directions about the up axis changes
// neither Q nor z. Bayesian quadrature needs of it (O'Hagan, "Bayes-Hermite quadrature", J. Stat. Plan. Inf. 1991):
//     z(w) = integral over H of k(w, w') p(w') dw',     zz = integral over H of z(w) p(w) dw,
// where f p is the integrand: p is its known part, and the Gaussian process models f alone.
#pragma once

#include "numerics/portable_math.h"

#include <utility>

namespace bmc {
// The known part p of the integrand: 1, or cos(theta).
enum class Known { nothing, cosine };
constexpr std::pair<const char*, Known> known_names[] = {{"nothing", Known::nothing}, {"cosine", Known::cosine}};

// Add a family here and to the table; the compiler then names the two other places: k, and its mean over a cap.
enum class CovarianceFamily { sobolev, squared_exponential };
constexpr std::pair<const char*, CovarianceFamily> covariance_names[] = {
    {"sobolev", CovarianceFamily::sobolev}, {"squared-exponential", CovarianceFamily::squared_exponential}};

// A family of covariances and the value of its parameter.
// - sobolev, smoothness s in (1, 2): k(r) = C - r^(2s - 2), C = 2^(2s - 1) / s (Brauchart, Saff, Sloan & Womersley,
//   "QMC designs", Mathematics of Computation 2014). At s = 3/2, k(r) = 8/3 - r falls straight from 8/3 to 2/3. Its
//   functions are continuous, as radiance is between edges, with kinks.
// - squared_exponential, length-scale l >= 0.05: k(r) = exp(-r^2 / 2 l^2). Its functions have all derivatives. Below
//   l = 0.05, e^(-1 / l^2) comes close to underflow.
class Covariance {
public:
    // Throws std::invalid_argument for a parameter outside of these ranges.
    explicit Covariance(CovarianceFamily family = CovarianceFamily::sobolev, double parameter = 1.5);

    CovarianceFamily family() const { return family_; }
    double parameter() const { return parameter_; }

    // k of a squared chord, in [0, 4].
    double k(double squared_chord) const {
        if (has_closed_form_) return constant_ - std::sqrt(squared_chord);
        switch (family_) {
            case CovarianceFamily::sobolev: return constant_ - portable::pow(squared_chord, exponent_);
            case CovarianceFamily::squared_exponential: return portable::exp(-0.5 * kappa_ * squared_chord);
        }
        return 0;
    }

    // z of a direction with this cos(theta), in [0, 1], and zz. The known part cos(theta) goes with Sobolev 3/2
    // only. Both functions throw std::invalid_argument for anything else.
    double z(double cos_theta, Known known = Known::nothing) const;
    double zz(Known known = Known::nothing) const;

private:
    double cap_mean(double height) const;
    double z_by_caps(double cos_theta) const;
    double squared_exponential_z(double cos_theta) const;

    CovarianceFamily family_;
    double parameter_;
    double exponent_, constant_;  // of sobolev: s - 1 and C
    double kappa_;                // of squared_exponential: 1 / l^2
    bool has_closed_form_;        // Sobolev 3/2
    double zz_;                   // for p = 1
};
}  // namespace bmc
