// A Gaussian process over the hemisphere, and the Bayesian Monte Carlo estimate of an integral
// (Rasmussen & Ghahramani, "Bayesian Monte Carlo", NIPS 2003; O'Hagan 1991):
//     Q_ij = k(w_i, w_j) + noise^2 delta_ij,   weights = Q^-1 z,   integral of f p over H ~ sum of weights_i f(w_i),
// where p is the known part of the integrand: 1 as in the practice, or cos(theta).
//
// The prior mean is zero. Q, z and the weights depend on the directions alone, not on f. So a process is made once, for
// any number of integrals and threads.
#pragma once

#include "numerics/cholesky.h"
#include "numerics/vec3.h"
#include "quadrature/covariance.h"

#include <vector>

namespace bmc {
class GaussianProcess {
public:
    // n >= 1 unit directions in the upper hemisphere. noise >= 0: standard deviation of the samples' error over the
    // amplitude; it keeps Q positive definite where samples nearly coincide. Throws std::invalid_argument for other
    // arguments and for a known part for which the covariance has no closed form; NotPositiveDefinite.
    GaussianProcess(const Covariance& covariance, double noise, std::vector<Vec3> directions,
                    Known known = Known::nothing);

    const std::vector<Vec3>& directions() const { return directions_; }

    // z_j, the integral over H of k(w_j, w) p(w) dw.
    const std::vector<double>& z() const { return z_; }

    // Q^-1 z by two triangular solves.
    const std::vector<double>& weights() const { return weights_; }

    const Cholesky& cholesky() const { return cholesky_; }

    // Q^-1, n x n; an estimate does not need it.
    Matrix inverse_covariance() const { return cholesky_.inverse(); }

    // The estimate of the integral of f p over H; values[i] = f(directions()[i]), n of them in all these functions.
    double integral(const std::vector<double>& values) const;

    // Posterior variance of the integral for a process of amplitude 1: zz - z^T Q^-1 z, not below 0.
    double variance() const { return variance_; }

    // The amplitude a of k that makes the values most likely, a^2 = Y^T Q^-1 Y / n.
    double amplitude(const std::vector<double>& values) const;

    // Standard error that the process predicts for integral(values): amplitude * sqrt(variance).
    double standard_error(const std::vector<double>& values) const;

    // Log evidence of the values up to a constant, with the amplitude that maximises it: -n/2 log a^2 - 1/2 log det Q
    // (Rasmussen & Williams, "Gaussian Processes for Machine Learning", 2006, eq. 5.8). Compare processes with one
    // known part only.
    double log_evidence(const std::vector<double>& values) const;

private:
    void require_one_value_per_direction(const std::vector<double>& values) const;

    std::vector<Vec3> directions_;
    std::vector<double> z_;
    Cholesky cholesky_;
    std::vector<double> weights_;
    double variance_;
};

// z of each direction. Throws std::invalid_argument for one below the horizon.
std::vector<double> z_of(const Covariance& covariance, const std::vector<Vec3>& directions,
                         Known known = Known::nothing);

// Q, n x n, its upper triangle only: what Cholesky reads.
Matrix covariance_matrix(const Covariance& covariance, double noise, const std::vector<Vec3>& directions);
}  // namespace bmc
