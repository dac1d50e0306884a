// A Gaussian process over the hemisphere, and the Bayesian Monte Carlo estimate of an integral
// (Rasmussen & Ghahramani, "Bayesian Monte Carlo", NIPS 2003; O'Hagan 1991):
//     Q_ij = k(w_i, w_j) + noise^2 delta_ij,   weights = Q^-1 z,   integral of f p over H ~ sum of weights_i f(w_i),
// where p is the known part of the integrand: 1 as in the practice, or cos(theta).
//
// The prior mean is zero, or that of a uniform light of unknown radiance: with h_j what this light would give at sample
// j and b = pi its integral, the weights become Q^-1 z + Q^-1 h (b - h^T Q^-1 z) / (h^T Q^-1 h), the best unbiased ones
// (generalised least squares; O'Hagan 1991, section 3).
//
// Q, z and the weights depend on the directions alone, never on f: a process is made once, and serves any number of
// integrals and threads.
#pragma once

#include "numerics/cholesky.h"
#include "numerics/vec3.h"
#include "quadrature/covariance.h"

#include <vector>

enum class PriorMean { zero, uniform };
constexpr std::pair<const char*, PriorMean> prior_mean_names[] = {{"zero", PriorMean::zero},
                                                                  {"uniform", PriorMean::uniform}};

// What is assumed of the integrand besides the covariance.
struct Prior {
    KnownPart known = KnownPart::nothing;
    PriorMean mean = PriorMean::zero;
};

class GaussianProcess {
public:
    // n >= 1 unit directions in the upper hemisphere; noise >= 0 is the standard deviation of the samples' error in
    // units of the amplitude, and what keeps Q positive definite where samples nearly coincide. Throws
    // std::invalid_argument for other arguments, a known part that the covariance has no closed form for, and the mean
    // uniform if every direction lies on the horizon; NotPositiveDefinite, its text naming the covariance.
    GaussianProcess(const Covariance& covariance, double noise, std::vector<Vec3> directions, Prior prior = {});

    const std::vector<Vec3>& directions() const { return directions_; }

    // z_j, the integral over H of k(w_j, w) p(w) dw.
    const std::vector<double>& z() const { return z_; }

    // Q^-1 z by two triangular solves, corrected for the prior mean.
    const std::vector<double>& weights() const { return weights_; }

    const Cholesky& cholesky() const { return cholesky_; }

    // Q^-1, n x n, which leave-one-out needs and an estimate does not.
    Matrix inverse_covariance() const { return cholesky_.inverse(); }

    // The estimate of the integral of f p over H; values[i] = f(directions()[i]), n of them in all these functions.
    double integral(const std::vector<double>& values) const;

    // Posterior variance of the integral for a process of amplitude 1: zz - z^T Q^-1 z, not below 0; an unknown mean
    // adds (b - h^T Q^-1 z)^2 / (h^T Q^-1 h).
    double variance() const { return variance_; }

    // The amplitude a of k that makes the values most likely, a^2 = Y^T Q^-1 Y / n; for an unknown mean of what its
    // best estimate leaves, and over n - 1. This and all below throw std::invalid_argument for that and n = 1.
    double amplitude(const std::vector<double>& values) const;

    // Standard error that the process predicts for integral(values): amplitude * sqrt(variance).
    double standard_error(const std::vector<double>& values) const;

    // Log evidence of the values up to a constant, with the amplitude that maximises it: -n/2 log a^2 - 1/2 log det Q
    // (Rasmussen & Williams, "Gaussian Processes for Machine Learning", 2006, eq. 5.8); for an unknown mean n - 1 takes
    // the place of n and -1/2 log(h^T Q^-1 h) is added (ibid., eq. 2.45). Compare processes of one prior only.
    double log_evidence(const std::vector<double>& values) const;

    // What each value differs by from its prediction by all the others: (Q^-1 Y)_i / (Q^-1)_ii (ibid., eq. 5.12),
    // Q^-1 less Q^-1 h h^T Q^-1 / (h^T Q^-1 h) in its place for an unknown mean. inverse: inverse_covariance().
    std::vector<double> leave_one_out(const std::vector<double>& values, const Matrix& inverse) const;

private:
    void require_one_value_per_direction(const std::vector<double>& values) const;
    void add_uniform_light(KnownPart known);
    double freedom() const;
    std::vector<double> deviations(std::vector<double> values) const;

    std::vector<Vec3> directions_;
    std::vector<double> z_;
    Cholesky cholesky_;
    std::vector<double> weights_;
    double variance_;
    std::vector<double> mean_;         // h; empty for the mean zero
    std::vector<double> solved_mean_;  // Q^-1 h
    double mean_information_ = 1;      // h^T Q^-1 h
};

// z of each direction. Throws std::invalid_argument for one below the horizon.
std::vector<double> hemisphere_integrals(const Covariance& covariance, const std::vector<Vec3>& directions,
                                         KnownPart known = KnownPart::nothing);

// Q, n x n, its upper triangle only: what Cholesky reads.
Matrix covariance_matrix(const Covariance& covariance, double noise, const std::vector<Vec3>& directions);
