// A Gaussian process over the hemisphere, and the Bayesian Monte Carlo estimate of an integral (Rasmussen & Ghahramani,
// "Bayesian Monte Carlo", NIPS 2003; O'Hagan 1991):
//     Q_ij = k(omega_i, omega_j) + noise^2 delta_ij,   w = Q^-1 z,   integral of f p over H ~ sum of w_i f(omega_i),
// where p is the known part of the integrand, for which the covariance has z: 1 as in the practice, or cos(theta). The
// prior mean of f is zero. Q, z and the weights depend on the directions alone, not on f: one process serves any number
// of integrals and threads.
#pragma once

#include "base/vec3.h"
#include "linear_algebra/cholesky.h"
#include "quadrature/covariance.h"

namespace bmc {
struct GaussianProcess {
    // Made in this order, each from those before it.
    Known known;  // p, of the covariance
    std::vector<Vec3> directions;
    std::vector<double> z;        // z_j, the integral over H of k(omega_j, omega) p(omega) d omega
    Cholesky cholesky;            // the factor of Q
    std::vector<double> weights;  // w = Q^-1 z
    double zz;                    // of the covariance
    double variance;              // V = zz - z^T Q^-1 z >= 0, of the integral for an f of amplitude 1

    // n >= 1 unit directions in H. noise >= 0: the standard deviation of the samples' error, in units of the amplitude
    // of f (below). Its square is added to the diagonal of Q, so that two equal directions do not make Q singular.
    // Throws std::invalid_argument for a noise below 0, for no direction, and for a direction below the horizon;
    // NotPositiveDefinite if Q cannot be factored.
    GaussianProcess(const Covariance& covariance, double noise, std::vector<Vec3> unit_directions);

    // Q^-1, n x n. An estimate does not need it.
    Matrix inverse_covariance() const { return cholesky.inverse(); }

    // The estimate of the integral of f p over H. Here and below values[i] = f(directions[i]), n of them.
    double integral(const std::vector<double>& values) const;

    // The amplitude a of f, the typical size of its values. With a^2 k in place of k and a times the noise, the weights
    // stay the same, V becomes a^2 V, and Y^T Q^-1 Y has the mean n a^2. So a^2 is estimated as Y^T Q^-1 Y / n. Squares
    // of values below 1e-140 or above 1e150 would lose digits or overflow.
    double amplitude(const std::vector<double>& values) const;

    // Log evidence of the values up to a constant, with the amplitude that maximises it, a: -n/2 log a^2 - 1/2 log det
    // Q (Rasmussen & Williams, "Gaussian Processes for Machine Learning", 2006, eq. 5.8). Processes with one known part
    // can be compared by it.
    double log_evidence(const std::vector<double>& values) const;

    // The error bar of integral(values): a sqrt(V), the posterior standard deviation. nan if V is below 1e-12 zz: then
    // V is only the rounding error of a difference.
    double error_bar(const std::vector<double>& values) const {
        return variance < 1e-12 * zz ? NAN : amplitude(values) * std::sqrt(variance);
    }
};

// What the constructor computes: z of each direction (throws std::invalid_argument for one below the horizon), Q (n x n
// and symmetric), w from the factor of Q, and V, which is not negative.
std::vector<double> z_of(const Covariance& covariance, const std::vector<Vec3>& directions);
Matrix covariance_matrix(const Covariance& covariance, double noise, const std::vector<Vec3>& directions);
std::vector<double> bayesian_weights(const Cholesky& cholesky, const std::vector<double>& z);
double posterior_variance(double zz, const std::vector<double>& z, const std::vector<double>& weights);
}  // namespace bmc
