// Covariance functions on the sphere and their exact integrals over the hemisphere. A covariance k depends on two
// directions through the squared chord r^2 = |w - w'|^2 = 2 - 2 w.w' alone: rotating a set of directions about the up
// axis changes neither Q nor z. What Bayesian quadrature needs of it is closed here (O'Hagan, "Bayes-Hermite
// quadrature", J. Stat. Plan. Inf. 1991):
//     z(w)  = integral over H of k(w, w') p(w') dw',     zz = integral over H of z(w) p(w) dw,
// where p is the known part of the integrand f p, and the Gaussian process models f alone.
#pragma once

#include "numerics/portable_math.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace bmc {
// What is known of the integrand L(w) V(w) cos(theta): nothing, the cosine, or the light and the cosine. A process
// takes the last two alike: p = cos(theta), and it models what is left.
enum class Known { nothing, cosine, light };
constexpr std::pair<const char*, Known> known_names[] = {
    {"nothing", Known::nothing}, {"cosine", Known::cosine}, {"light", Known::light}};
constexpr std::pair<const char*, Known> process_known_names[] = {known_names[0], known_names[1]};

class Covariance {
public:
    virtual ~Covariance() = default;

    // k of a squared chord, in [0, 4].
    double operator()(double squared_chord) const {
        evaluate(&squared_chord, 1);
        return squared_chord;
    }

    // In place: squared chords become covariances. With one call for many values, those of plain arithmetic are
    // computed side by side.
    virtual void evaluate(double* squared_chords, std::size_t count) const = 0;

    // z of a direction, by its elevation cosine in [0, 1]; throws std::invalid_argument for any other.
    double z(double cos_theta, Known known = Known::nothing) const {
        std::vector<double> one{cos_theta};
        integrate(one, known);
        return one[0];
    }

    // In place: elevation cosines become z. This and zz throw std::invalid_argument for a known part with
    // which this covariance has no closed form.
    virtual void integrate(std::vector<double>& cos_thetas, Known known = Known::nothing) const = 0;
    virtual double integral_of_z(Known known = Known::nothing) const = 0;
};

// k(r) = C - r^(2s - 2), C = 2^(2s - 1) / s: the reproducing kernel of the Sobolev space of smoothness s on the sphere,
// up to equivalence of norms (Brauchart, Saff, Sloan & Womersley, "QMC designs", Mathematics of Computation 2014). It
// models a function that is continuous but need not be smooth, as radiance is. The known part cos(theta) has a closed
// form at s = 3/2.
class Sobolev final : public Covariance {
public:
    // Smoothness s in (1, 2), std::invalid_argument for any other; at 3/2, k(r) = 8/3 - r and z is an elliptic
    // integral.
    explicit Sobolev(double smoothness = 1.5);

    void evaluate(double* squared_chords, std::size_t count) const override;
    void integrate(std::vector<double>& cos_thetas, Known known = Known::nothing) const override;
    double integral_of_z(Known known = Known::nothing) const override;

private:
    bool has_closed_form() const { return nodes_.empty(); }
    double rim_sum(double cos_theta) const;

    double exponent_;  // s - 1
    double constant_;  // C
    double integral_of_z_;
    std::vector<double> nodes_;  // of the rim integral; empty at s = 3/2, which needs none
};

// k(r) = exp(-r^2 / 2 l^2), length-scale l: models a function with all derivatives.
class SquaredExponential final : public Covariance {
public:
    // l in [0.05, inf). Throws std::invalid_argument below: there e^(-1 / l^2) heads for underflow.
    explicit SquaredExponential(double length_scale = 1);

    void evaluate(double* squared_chords, std::size_t count) const override;
    void integrate(std::vector<double>& cos_thetas, Known known = Known::nothing) const override;
    double integral_of_z(Known known = Known::nothing) const override;

private:
    double kappa_;      // 1 / l^2
    double even_part_;  // pi (1 - e^(-2 kappa)) / kappa: the part of z that is the same for all directions
};

// The families of covariances that experiments and options name, each with one parameter: smoothness, length-scale.
enum class CovarianceFamily { sobolev, squared_exponential };
constexpr std::pair<const char*, CovarianceFamily> covariance_names[] = {
    {"sobolev", CovarianceFamily::sobolev}, {"squared-exponential", CovarianceFamily::squared_exponential}};

// Throws what the family's constructor throws.
std::unique_ptr<Covariance> make_covariance(CovarianceFamily family, double parameter);
}  // namespace bmc
